#include "render/shape/root_jobs.h"

namespace firstlight::render {

void RootBatch::add(std::size_t ray, std::uint32_t part, std::size_t order, const double* c, std::size_t stride,
                    double low, double high) {
  polynomials_.order = order;
  for (std::size_t k = 0; k <= order; ++k) polynomials_.c[k][count_] = c[k * stride];
  polynomials_.low[count_] = low;
  polynomials_.high[count_] = high;
  ray_[count_] = static_cast<std::uint8_t>(ray);
  part_[count_] = part;
  root_count_[count_] = 0;
  ++count_;
}

void RootBatch::solve() {
  const std::uint64_t all = count_ == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count_) - 1;
  RootColumns roots(polynomials_, all);
  Column<double> root;
  for (std::uint64_t open = all; (open = roots.next(open, root)) != 0;) {
    for (std::uint64_t left = open; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctzll(left));
      if (root_count_[i] < kMostRoots) root_[i][root_count_[i]++] = root[i];
    }
  }
}

}  // namespace firstlight::render
