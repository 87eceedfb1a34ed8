#include <gmock/gmock.h>

#include "studies/support/error.hpp"
#include "tests/studies/codes/mover.hpp"

namespace mpmvv::codes::capability_test {

using support::UsageError;
using testing::HasSubstr;

class Capability : public testing::Test {
 protected:
  const Mover mover_;
};

TEST_F(Capability, WhatACodeCannotDoIsRefused) {
  const auto refusal = [&](const std::string& without, const std::string& instead) {
    std::string text = Mover::text;
    text.replace(text.find(without), without.size(), instead);
    mover_.adapter(text);
    try {
      require_able(read_adapter(mover_.folder() / "adapter.toml"), settings::make_case(Mover::settings()));
    } catch (const UsageError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal("none", "none"), "");
  EXPECT_THAT(refusal("[2]", "[1, 3]"), HasSubstr("it has 2 dimensions (it can: 1, 3)"));
  EXPECT_THAT(refusal("\"reference\", ", ""), HasSubstr("force_form 'reference' (it can: none)"));
  EXPECT_THAT(refusal("\"periodic\"", "\"free\""), HasSubstr("boundary 'periodic'"));
  EXPECT_THAT(refusal("velocity = true", "velocity = false"), HasSubstr("it starts with a velocity"));
}

/// A ring so thin has no particle on four cells.
TEST_F(Capability, IsAskedOfAStartWithParticles) {
  std::string text = Mover::text;
  text.replace(text.find("[\"periodic\"]"), 12, "[\"free\"]");
  mover_.adapter(text);
  auto settings = Mover::settings("256");
  settings[0].value = "ring";
  settings.push_back({"param.inner_radius", "0.99", "test"});
  settings.push_back({"param.amplitude", "0.001", "test"});
  settings.push_back({"force_form", "none", "test"});
  EXPECT_THAT([&] { require_able(read_adapter(mover_.folder() / "adapter.toml"), settings::make_case(settings)); },
              testing::ThrowsMessage<UsageError>(HasSubstr("it starts deformed")));
}

}  // namespace mpmvv::codes::capability_test
