#include "coordinator/plan/pieces/outline_chains.h"

#include <string>
#include <utility>

#include "coordinator/plan/pieces/outline_sides.h"

namespace tilemend {
namespace {

class ChainCloser {
 public:
  ChainCloser(const std::vector<int32_t>& loop, const Rim& rim, const GridLines& lines, const ClosingCells& closing,
              const std::vector<double>& piece_border)
      : loop_(loop),
        rim_(rim),
        lines_(lines),
        closing_(closing),
        piece_border_(piece_border),
        tile_(rim.edges[loop[0]].owner) {}

  OutlineChains Run() {
    const size_t n = loop_.size();
    size_t start = 0;
    while (start < n && !IsOutline(loop_[start])) ++start;
    std::vector<int32_t> chain;
    for (size_t i = start; i < start + n; ++i) {
      const int32_t e = loop_[i % n];
      if (!IsOutline(e)) {
        chain.push_back(e);
        continue;
      }
      Close(chain);
      chain.clear();
      CountBorder(e);
    }
    Close(chain);
    LeaveOutlines();
    return std::move(result_);
  }

 private:
  bool IsOutline(int32_t e) const { return closing_[e] != rim_.edges[e].owner || piece_border_[e] >= 0; }

  void CountBorder(int32_t e) {
    if (piece_border_[e] >= 0) ++border_edges_;
  }

  void Close(const std::vector<int32_t>& chain) {
    if (chain.empty()) return;
    const int32_t first = rim_.edges[chain.front()].from, last = rim_.edges[chain.back()].to;
    std::vector<RimSegment> loop = Reversed(rim_, chain);
    if (first == last) {
      result_.loops.push_back(std::move(loop));
      return;
    }
    if (chain.size() == 1) {
      ++short_edges_;
      return;
    }
    const Point3& p = rim_.points[first].position;
    const Point3& q = rim_.points[last].position;
    if (!FaceEachOther(p, q, tile_, lines_, kSamePlane)) {
      result_.open_runs.push_back(chain);
      return;
    }
    if (!OnOneSide(p, q, tile_, lines_)) ++border_edges_;  // the closing segment
    loop.push_back({first, last, true});
    result_.loops.push_back(std::move(loop));
  }

  void LeaveOutlines() {
    if (border_edges_ > 0) Leave("outline of a piece of a tile beside another piece", border_edges_);
    if (short_edges_ > 0) Leave("single boundary edges beside a tile's outline, which enclose nothing", short_edges_);
  }

  void Leave(std::string reason, int64_t edges) {
    result_.left.push_back({tile_, std::move(reason), -1, edges, false});
  }

  const std::vector<int32_t>& loop_;
  const Rim& rim_;
  const GridLines& lines_;
  const ClosingCells& closing_;
  const std::vector<double>& piece_border_;
  const CellId tile_;
  OutlineChains result_;
  int64_t border_edges_ = 0, short_edges_ = 0;
};

}  // namespace

OutlineChains CloseChains(const std::vector<int32_t>& loop, const Rim& rim, const GridLines& lines,
                          const ClosingCells& closing, const std::vector<double>& piece_border) {
  return ChainCloser(loop, rim, lines, closing, piece_border).Run();
}

}  // namespace tilemend
