#include "studies/claims/claim.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace mpmvv::claims {

using records::ClaimPart;
using records::PartVerdict;

const std::vector<ClaimText>& claim_list() {
  static const std::vector<ClaimText> claims{
      // Steffen et al. 2008
      {"S-basis", "every basis is a convolution of boxes; uGIMP runs from linear to quadratic B-spline"},
      {"S-open", "open-knot B-splines: unity at the boundary, partition of unity, non-zero slopes"},
      {"S-fig4", "the GIMP gradient weight has kinks where the weight itself looks smooth"},
      {"S-jump", "closed forms of the jump error of a particle that spans kinks"},
      {"S-fig6", "internal-force quadrature: second order below the smoothing length, towards first above"},
      {"S-fig7", "projected density spreads beyond the body, further for wider bases"},
      {"S-fig8", "unstable when the smoothing length falls below the particle width"},
      {"S-fig9", "a larger smoothing length is stable to a larger CFL number"},
      {"S-fig10", "bar: linear stops converging, quadratic B-splines are second order to a plateau"},
      {"S-fig11", "bar: ghost-node Dirichlet is first order, periodic and open-knot second"},
      {"S-acc", "wall acceleration zero or by difference: neither is superior"},
      {"S-fig12", "cube: cpGIMP second order, periodic B-spline nearly, ghost-node B-spline first"},
      {"S-ghost", "cpGIMP particles of an aligned body reach no ghost node"},
      {"S-force", "body force on the grid or from the particles"},
      {"S-fig13", "cpGIMP voxels tile the deformed cube"},
      // Wallstedt and Guilkey 2008
      {"W-one", "a general solver reproduces the one-particle recursions"},
      {"W-cd", "CD is USL but for the start; halving the first acceleration works nearly as well as v(-dt/2)"},
      {"W-fig2", "particle displacements of square and ring at three times"},
      {"W-fig3", "square, error against CFL number"},
      {"W-fig4", "square, error against cell size"},
      {"W-norms", "L1, L2 and Linf show the same orders"},
      {"W-small", "convergence is better for small deformation"},
      {"W-mpm", "USF-MPM beats USL-MPM, neither beats UVF-MPM"},
      {"W-fig6", "ring, error against CFL number"},
      {"W-fig7", "ring, error against cell size"},
      {"W-node", "nodal error by inverting the motion"},
      {"W-rk", "Runge-Kutta brings no accuracy"},
      {"W-spatial", "with the best choices spatial error dominates"},
      // Nairn and Hammerquist 2021
      {"N-inverse", "the k-term expansion, its recursion and its limit"},
      {"N-equal", "the projection of XPIC(k)"},
      {"N-pic", "three PIC variants share the acceleration"},
      {"N-fig2", "two blocks: energy loss against cell size and time step"},
      {"N-fig3a", "FMPM's dissipation against cell size and k"},
      {"N-fig3b", "FMPM's dissipation against the time step"},
      {"N-fig4", "energy loss against k and shape function"},
      {"N-fig5", "stress update schemes with FLIP and FMPM"},
      {"N-fig6", "traction pulse: stress error"},
      {"N-fig7a", "stretching bar: error against wall depth"},
      {"N-fig7b", "stretching bar: PIC variants"},
      {"N-fig8", "shock in nickel"},
      {"N-mincfl", "smallest CFL number and k at which FMPM beats FLIP"},
      {"N-flipv", "FLIP with the effective velocity is poor"},
      {"N-elong", "elongation at separation"},
      {"N-dims", "the stretching bar in one, two and three dimensions"},
      {"N-temp", "the shock's temperature plateau"},
      {"N-cost", "run time against k"},
      // Brannon, the MPM mapping
      {"B-lsq", "the consistent mapping minimises the weighted residual"},
      {"B-phi", "grid field and particle-basis field are one"},
      {"B-vol", "volume instead of mass weighting"},
      {"B-i", "particle basis (i): no interpolation of the particle data"},
      {"B-ii", "particle basis (ii): partition of unity"},
      {"B-iii", "particle basis (iii): linear completeness"},
      {"B-iv", "particle basis (iv): piecewise differentiable"},
      {"B-v", "particle basis (v): not symmetric about the particle"},
      {"B-vi", "particle basis (vi): its shape depends on the place among the nodes"},
      {"B-vii", "particle basis (vii): particles in one element share their influence domain"},
      {"B-viii", "particle basis (viii): between 0 and 1"},
      {"B-ix", "particle basis (ix): falls monotonically from its maximum"},
      {"B-x", "particle basis (x): invariant when grid and particles translate together"},
      {"B-xi", "particle basis (xi): changes when particles translate on the grid, with the average gradient"},
      {"B-xii", "particle basis (xii): its integral does not change when particles translate"},
      {"B-xiii", "particle basis (xiii): invariant under homogeneous deformation with the grid, else not"},
      {"B-xiv", "particle basis (xiv): the field of f_p = 1, all others 0"},
      {"B-fig16.5", "the particle basis under rigid translation"},
      // Ours
      {"X-general", "ring with moving surfaces and non-zero Poisson's ratio"},
      {"X-ring", "second order on the free-surface ring with a conforming fill"},
      {"X-mirror", "folded ghost nodes give the periodic result at a symmetry plane"},
      {"X-vortex", "orders on the generalized vortex"},
      {"X-derive", "closed-form body forces equal the derived ones to 1e-10"},
      {"X-wall", "the combined wall method is unstable for k >= 3; its cure"},
      {"X-highk", "FMPM's instability at high k is gain on near-null modes"},
      {"X-cost", "least run time for a given error"},
      {"X-mutants", "the gate catches every planted mistake"},
  };
  return claims;
}

namespace {

std::string verdict_of(const std::vector<ClaimPart>& parts) {
  const auto count = [&parts](PartVerdict v) {
    return std::count_if(parts.begin(), parts.end(), [v](const ClaimPart& part) { return part.verdict == v; });
  };
  const auto holds = count(PartVerdict::holds), fails = count(PartVerdict::fails);
  const auto unknown = count(PartVerdict::inconclusive);
  if (holds == 0 && fails == 0) return unknown == 0 && !parts.empty() ? "shown" : "open";
  if (fails == 0 && unknown == 0) return "confirmed";
  return holds == 0 ? "refuted" : "partly";
}

std::string evidence_of(const std::vector<ClaimPart>& parts) {
  std::vector<std::string> texts;
  for (const ClaimPart& part : parts) {
    const std::string reason = part.reason.empty() ? "" : " Reason: " + part.reason;
    texts.push_back(fmt::format("{}: {} [{}].{}", part.statement, part.evidence, to_string(part.verdict), reason));
  }
  return fmt::format("{}", fmt::join(texts, "\n"));
}

}  // namespace

std::vector<Claim> judge_claims(const std::vector<records::StudyResult>& studies) {
  std::vector<Claim> claims;
  for (const ClaimText& text : claim_list()) {
    Claim claim{text.id, text.statement, "", "", {}};
    std::vector<ClaimPart> parts;
    for (const records::StudyResult& study : studies)
      for (const ClaimPart& part : study.parts) {
        if (part.claim != claim.id) continue;
        parts.push_back(part);
        if (claim.studies.empty() || claim.studies.back() != study.name) claim.studies.push_back(study.name);
      }
    claim.verdict = verdict_of(parts);
    claim.evidence = evidence_of(parts);
    claims.push_back(claim);
  }
  return claims;
}

}  // namespace mpmvv::claims
