// Neighbour rows with a skin hold half as many pairs again as the kernel reaches. This picks those
// that it does reach, once for all the sums of a step.
#include "pair_geometry.hpp"
#include "passes.hpp"

namespace parapet::solver::PARAPET_ISA {
namespace {

// Writes the slots [from, to) again, each lane's indices that are to be kept in their order, and
// says where they end. Lanes with fewer than others are filled up with the ghost.
template <class Kept>
PARAPET_INLINE std::int32_t* pick(const std::int32_t* from, const std::int32_t* to,
                                  std::int32_t ghost, std::int32_t* out, const Kept& kept) {
  std::int64_t next[lanes] = {0, 1, 2, 3, 4, 5, 6, 7};  // where each lane goes on
#if defined(__AVX512F__) && defined(__AVX512VL__)
  __m256i places = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
  for (const std::int32_t* index = from; index != to; index += lanes) {
    const __mmask8 keep = _mm512_movepi64_mask((__m512i)kept(index));
    const __m256i all = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(index));
    _mm256_mask_i32scatter_epi32(out, keep, places, all, sizeof *out);
    places = _mm256_mask_add_epi32(places, keep, places, _mm256_set1_epi32(lanes));
  }
  std::int32_t last[lanes];
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(last), places);
  for (int l = 0; l < lanes; ++l) next[l] = last[l];
#else
  for (const std::int32_t* index = from; index != to; index += lanes) {
    const v8m keep = kept(index);
    // Every index is written and the next one over it unless it was kept: a branch would be guessed
    // wrong too often.
    for (int l = 0; l < lanes; ++l) {
      out[next[l]] = index[l];
      next[l] += keep[l] & lanes;
    }
  }
#endif
  std::int64_t end = 0;
  for (int l = 0; l < lanes; ++l) end = next[l] - l > end ? next[l] - l : end;
  for (int l = 0; l < lanes; ++l) {
    for (; next[l] < end; next[l] += lanes) out[next[l]] = ghost;
  }
  return out + end;
}

template <bool periodic>
void rows_of(const FlowArrays& a, const ReachedRows& rows, int begin, int end) {
  const FlowConstants& c = a.constants;
  const FluidView& f = a.fluid;
  // rounding must not lose a pair that a sum would see; beyond the support its weight is zero
  const v8d reach2 = splat(4.0 * (1.0 + 1e-9) * c.smoothing_length * c.smoothing_length);
  std::int32_t* next = begin < end ? rows.index + a.rows.begin[begin / lanes] : rows.index;
  const auto place = [&] { return static_cast<std::int32_t>(next - rows.index); };
  for (int i = begin; i < end; i += lanes) {
    const Group group(i, end);
    const Row row(a.rows, i);
    const int g = i / lanes;
    const v8d x = group.load(f.x), z = group.load(f.z);
    const auto reached = [&](const TwoLanes& other) {
      const v8d rx = nearest<periodic>(c, x - other.x), rz = z - other.z;
      return rx * rx + rz * rz < reach2;
    };
    rows.begin[g] = place();
    next = pick(row.fluid, row.wall, f.n, next,
                [&](const std::int32_t* j) { return reached(gather_two(f.motion, j)); });
    rows.wall_begin[g] = place();
    next = pick(row.wall, row.end, a.wall.n, next,
                [&](const std::int32_t* k) { return reached(gather_two(a.wall.place, k)); });
    rows.end[g] = place();
  }
}

}  // namespace

void reached_rows(const FlowArrays& a, const ReachedRows& rows, int begin, int end) {
  PARAPET_PASS(rows_of, a, rows, begin, end);
}

}  // namespace parapet::solver::PARAPET_ISA
