#include "engine/probe/question_row.h"

namespace vamp::probe {

Question question_row(const BrdfQuestion& q, bool packed) {
  const auto& p = q.lobe.params;
  Question row{.wi = q.wi,
               .model = static_cast<uint32_t>(q.lobe.model),
               .wo = q.wo,
               .variant = q.lobe.variant,
               .p0 = p[0],
               .p1 = p[1],
               .p2 = p[2],
               .p3 = p[3],
               .p4 = p[4],
               .p5 = p[5],
               .u0 = q.u.x,
               .u1 = q.u.y};
  if (packed) {
    const PackedLobe lobe = pack_lobe(q.lobe);
    row.k0 = lobe.k[0];
    row.k1 = lobe.k[1];
    row.k2 = lobe.k[2];
    row.k3 = lobe.k[3];
    row.tag = lobe.tag;
  }
  return row;
}

}  // namespace vamp::probe
