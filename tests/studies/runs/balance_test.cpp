#include "studies/runs/balance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "studies/runs/run_case.hpp"
#include "studies/settings/settings.hpp"

namespace mpmvv::runs::balance_test {

records::Balance of_translation(const char* boundary, const char* steps) {
  const std::vector<settings::Setting> settings{{"problem", "translation", ""},
                                                {"basis", "bspline2", ""},
                                                {"integrator", "usl", ""},
                                                {"boundary", boundary, ""},
                                                {"cells", "8", ""},
                                                {"ppc", "2", ""},
                                                {"cfl", "0.2", ""},
                                                {"steps", steps, ""}};
  const records::Record record = run_case(settings::make_case(settings), 1);
  EXPECT_EQ(record.status, records::Status::ok) << record.reason;
  return record.balance;
}

TEST(Balance, OfAngularMomentumIsNotMeasuredWithAPeriodicAxis) {
  EXPECT_LT(of_translation("free", "20").angular_momentum, 1e-13);
  for (const char* boundary : {"periodic", "xmin=periodic,xmax=periodic,ymin=free,ymax=free"}) {
    const records::Balance wrapped = of_translation(boundary, "20");
    EXPECT_TRUE(std::isnan(wrapped.angular_momentum)) << boundary;
    EXPECT_LT(wrapped.momentum, 1e-13) << boundary;
  }
}

}  // namespace mpmvv::runs::balance_test
