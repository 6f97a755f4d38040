// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/cut_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <set>

#include "probes/placement/validity.h"

namespace welkin::placement {
namespace {

constexpr std::size_t kMostGrown = 31;  // nodes of a tree
constexpr double kLeastGain = 0.015;    // of a split, as a share of its own impurity
constexpr double kLeastOfAll = 0.004;   // and of the whole cell's
constexpr double kMaskShare = 0.5;      // weight of a mask's label beside that of a probe
constexpr double kParted = 0.15;        // share of parted samples, joined by some way, that do not shut a cell
constexpr double kAsGood = 0.85;        // of the best gain: among such splits the clearest is taken

/// Bits of the six cells that share a face with a cell.
constexpr std::array<std::uint32_t, 6> kFaceBits = {format::openBit(-1, 0, 0), format::openBit(1, 0, 0),
                                                    format::openBit(0, -1, 0), format::openBit(0, 1, 0),
                                                    format::openBit(0, 0, -1), format::openBit(0, 0, 1)};

/// Counts of a set of samples.
struct Counts {
  std::size_t all = 0;
  std::vector<std::size_t> fit, served;  // by label
  std::array<std::size_t, kFaceBits.size()> beside{}, shut{};

  explicit Counts(std::size_t labels) : fit(labels), served(labels) {}

  void add(const CutSample& s, const std::vector<std::uint8_t>& answers) {
    ++all;
    for (std::size_t k = 0; k < fit.size(); ++k) {
      fit[k] += answers[k] & 1U;
      served[k] += answers[k] >> 1;
    }
    for (std::size_t n = 0; n < kFaceBits.size(); ++n) {
      beside[n] += (s.beside & kFaceBits[n]) != 0 ? 1 : 0;
      shut[n] += (s.shut & kFaceBits[n]) != 0 ? 1 : 0;
    }
  }
  double impurity() const {
    const auto gini = [](std::size_t part, std::size_t whole) {
      return whole == 0
                 ? 0.0
                 : 2.0 * static_cast<double>(part) * static_cast<double>(whole - part) / static_cast<double>(whole);
    };
    double sum = 0.0;
    for (const std::size_t k : fit) sum += gini(k, all);
    for (std::size_t n = 0; n < kFaceBits.size(); ++n) sum += kMaskShare * gini(shut[n], beside[n]);
    return sum;
  }
};

class Grower {
 public:
  Grower(const CutSampler& sampler, const ProbeSight& sight, const geometry::SectorId& id, std::uint8_t probe,
         const std::vector<CutCandidate>& planes, std::vector<CutSample>& samples)
      : sight_(sight), probe_(probe), planes_(planes), samples_(samples), above_(planes.size()) {
    std::set<std::size_t> labels;
    if (probe != geometry::kNoProbe) labels.insert(probe);
    for (const CutSample& s : samples) labels.insert(s.nearest);
    label_.assign(labels.begin(), labels.end());
    for (CutSample& s : samples_) {
      std::vector<std::uint8_t>& row = answer_.emplace_back();
      for (const std::size_t k : label_)
        row.push_back(static_cast<std::uint8_t>((sampler.fits(s, k) ? 1 : 0) + (sampler.serves(s, k) ? 2 : 0)));
    }
    for (std::size_t i = 0; i < planes.size(); ++i)
      for (const CutSample& s : samples_)
        above_[i].push_back(format::aboveBy(planes[i].plane, fromCornerOf(id, s.position)));
  }

  /// Splits the leaf that gains most, until none needs it.
  CutTree grow() {
    std::vector<std::uint32_t> all(samples_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint32_t>(i);
    tree_.emplace_back().sample = std::move(all);
    whole_ = countsOf(tree_[0].sample).impurity();
    std::vector<std::optional<Split>> split = {splitOf(0)};
    while (tree_.size() + 2 <= kMostGrown) {
      std::optional<std::size_t> best;
      for (std::size_t i = 0; i < split.size(); ++i)
        if (split[i] && (!best || split[i]->gain > split[*best]->gain)) best = i;
      if (!best) break;
      const std::size_t node = *best, plane = split[node]->plane, first = tree_.size();
      tree_.resize(first + 2);
      for (const std::uint32_t i : tree_[node].sample)
        tree_[above_[plane][i] > 0.0F ? first + 1 : first].sample.push_back(i);
      tree_[node].plane = planes_[plane].plane;
      tree_[node].below = first;
      tree_[node].above = first + 1;
      tree_[node].sample.clear();
      split[node].reset();
      split.push_back(splitOf(first));
      split.push_back(splitOf(first + 1));
    }
    for (CutNode& node : tree_)
      if (!node.plane) makeLeaf(node);
    return std::move(tree_);
  }

 private:
  struct Split {
    std::size_t plane = 0;
    double gain = 0.0;
    float margin = 0.0F;
  };

  Counts countsOf(const std::vector<std::uint32_t>& samples) const {
    Counts counts(label_.size());
    for (const std::uint32_t i : samples) counts.add(samples_[i], answer_[i]);
    return counts;
  }

  std::optional<Split> splitOf(std::size_t node) const {
    const std::vector<std::uint32_t>& samples = tree_[node].sample;
    const Counts counts = countsOf(samples);
    return isPure(counts, samples) ? std::nullopt : bestSplit(counts, samples);
  }

  /// The label that serves a set best: by samples that it does not fit, the grid's probe first, by samples that it
  /// does not serve, then by distance.
  std::size_t bestLabel(const Counts& counts, const std::vector<std::uint32_t>& samples) const {
    Number3 middle(0.0);
    for (const std::uint32_t i : samples) middle += samples_[i].position / static_cast<double>(samples.size());
    const auto rank = [&](std::size_t k) {
      return std::tuple(counts.all - counts.fit[k], label_[k] != probe_, counts.all - counts.served[k],
                        distanceOf(sight_.position(label_[k]), middle), k);
    };
    std::size_t best = 0;
    for (std::size_t k = 1; k < label_.size(); ++k)
      if (rank(k) < rank(best)) best = k;
    return best;
  }

  bool isPure(const Counts& counts, const std::vector<std::uint32_t>& samples) const {
    if (samples.empty()) return true;
    for (std::size_t n = 0; n < kFaceBits.size(); ++n)
      if (isMany(counts.shut[n], counts.beside[n]) && isMany(counts.beside[n] - counts.shut[n], counts.beside[n]))
        return false;
    return counts.fit[bestLabel(counts, samples)] == counts.all;
  }

  std::optional<Split> bestSplit(const Counts& whole, const std::vector<std::uint32_t>& samples) const {
    const double before = whole.impurity();
    std::vector<Split> splits;
    double best_gain = 0.0;
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      Counts below(label_.size()), above(label_.size());
      float margin = std::numeric_limits<float>::infinity();
      for (const std::uint32_t s : samples) {
        (above_[i][s] > 0.0F ? above : below).add(samples_[s], answer_[s]);
        margin = std::min(margin, std::abs(above_[i][s]));
      }
      if (below.all == 0 || above.all == 0) continue;
      splits.push_back({i, before - below.impurity() - above.impurity(), margin});
      best_gain = std::max(best_gain, splits.back().gain);
    }
    std::erase_if(splits, [&](const Split& s) { return s.gain < kAsGood * best_gain; });
    if (splits.empty() || best_gain <= std::max(kLeastGain * before, kLeastOfAll * whole_)) return std::nullopt;
    const auto rank = [&](const Split& s) { return std::tuple(planes_[s.plane].middle, s.margin, s.gain); };
    return *std::max_element(splits.begin(), splits.end(),
                             [&](const Split& a, const Split& b) { return rank(a) < rank(b); });
  }

  void makeLeaf(CutNode& leaf) {
    const Counts counts = countsOf(leaf.sample);
    leaf.probe = leaf.sample.empty() ? probe_ : static_cast<std::uint8_t>(label_[bestLabel(counts, leaf.sample)]);
  }

  const ProbeSight& sight_;
  std::uint8_t probe_;
  const std::vector<CutCandidate>& planes_;
  std::vector<CutSample>& samples_;
  std::vector<std::size_t> label_;                 // probes
  std::vector<std::vector<std::uint8_t>> answer_;  // sample, label: 1 if it fits, 2 if it serves
  std::vector<std::vector<float>> above_;          // plane, sample
  CutTree tree_;
  double whole_ = 0.0;
};

std::size_t copySimplified(const CutTree& from, std::size_t node, CutTree& to) {
  const std::size_t index = to.size();
  to.push_back(from[node]);
  if (!from[node].plane) return index;
  const std::size_t below = copySimplified(from, from[node].below, to);
  const std::size_t above = copySimplified(from, from[node].above, to);
  const CutNode& b = to[below];
  const CutNode& a = to[above];
  if (!a.plane && !b.plane && a.probe == b.probe && (a.open & ~a.any & ~b.open) == 0 &&
      (b.open & ~b.any & ~a.open) == 0) {
    CutNode leaf = b;
    leaf.open = a.open & b.open;
    leaf.any = a.any & b.any;
    to.resize(index + 1);
    to[index] = leaf;
    return index;
  }
  to[index].below = below;
  to[index].above = above;
  return index;
}

}  // namespace

bool isMany(std::size_t parted, std::size_t all) {
  return static_cast<double>(parted) > kParted * static_cast<double>(all);
}

const CutNode& leafAt(const CutTree& tree, const format::FromCorner& p) {
  std::size_t node = 0;
  while (tree[node].plane) node = format::aboveBy(*tree[node].plane, p) > 0.0F ? tree[node].above : tree[node].below;
  return tree[node];
}

format::FromCorner besideWalls(const CutTree& tree, const format::FromCorner& p, format::FromCorner to) {
  for (int pass = 0; pass < 2; ++pass)
    for (std::size_t node = 0; tree[node].plane;) {
      const float above = format::aboveBy(*tree[node].plane, p);
      to = format::onSideOf(*tree[node].plane, above, to);
      node = above > 0.0F ? tree[node].above : tree[node].below;
    }
  return to;
}

CutTree growTree(const CutSampler& sampler, const ProbeSight& sight, const geometry::SectorId& id, std::uint8_t probe,
                 const std::vector<CutCandidate>& planes, std::vector<CutSample>& samples) {
  const bool fits = probe != geometry::kNoProbe && std::all_of(samples.begin(), samples.end(), [&](CutSample& s) {
                      return s.shut == 0 && sampler.fits(s, probe);
                    });
  if (!fits) return Grower(sampler, sight, id, probe, planes, samples).grow();
  CutTree tree(1);
  tree[0].probe = probe;
  for (std::size_t i = 0; i < samples.size(); ++i) tree[0].sample.push_back(static_cast<std::uint32_t>(i));
  return tree;
}

CutTree simplified(const CutTree& tree) {
  CutTree result;
  copySimplified(tree, 0, result);
  return result;
}

}  // namespace welkin::placement
