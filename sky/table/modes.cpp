// SPDX-License-Identifier: Apache-2.0
#include "sky/table/modes.h"

#include <algorithm>
#include <cmath>

#include "sh/matrix.h"
#include "sh/modes.h"

namespace welkin::table {
namespace {

constexpr std::size_t kRows = model::IrradianceProjector::kRows;
constexpr std::size_t kOrders = model::IrradianceProjector::kOrders;
constexpr std::size_t kOrdersCompared = 12;  ///< the remaining orders follow these and weigh nothing
constexpr std::size_t kBasis = 20;           ///< for one day
constexpr std::size_t kBasisMore = 8;        ///< for each further day
constexpr std::size_t kSteps = 24;           ///< steps of the refinement; more gain only a few hundredths
constexpr std::size_t kSnapshots = 300;      ///< about as many snapshots are searched for modes
constexpr std::size_t kNormalsApart = 4;     ///< every so many of the grid's normals are compared

}  // namespace

std::vector<double> ModeSet::weightsOf(std::span<const double> field) const {
  constexpr std::size_t kAtOnce = 4;  // sums that do not wait for each other
  std::vector<double> weight(count());
  for (std::size_t first = 0; first < weight.size(); first += kAtOnce) {
    const double* mode_of[kAtOnce];
    double sum[kAtOnce];
    for (std::size_t k = 0; k < kAtOnce; ++k) {
      mode_of[k] = vector[std::min(first + k, weight.size() - 1)].data();
      sum[k] = mode_of[k][0] * field[0];
    }
    for (std::size_t i = 1; i < field.size(); ++i)
      for (std::size_t k = 0; k < kAtOnce; ++k) sum[k] += mode_of[k][i] * field[i];
    std::copy_n(sum, std::min(kAtOnce, weight.size() - first), weight.begin() + static_cast<std::ptrdiff_t>(first));
  }
  return weight;
}

std::vector<double> DayModes::vectorOf(const FieldChannel& channel) {
  std::vector<double> v;
  v.reserve(kRows * kOrdersCompared + 2);
  for (std::size_t r = 0; r < kRows; ++r) {
    const auto edge = [](double row) { return det::yOfModeRow(std::clamp(row / (kRows - 1.0), 0.0, 1.0)); };
    const double place = static_cast<double>(r);
    const double share = edge(place + 0.5) - edge(place - 0.5);  // Share of the upper hemisphere.
    const double mean = std::sqrt(share);
    const double turning = std::sqrt(0.5 * share);
    for (std::size_t m = 0; m < kOrdersCompared; ++m)
      v.push_back(channel.series[r * kOrders + m] * (m == 0 ? mean : turning));
  }
  for (const std::size_t i : {model::polarIndex(1, 0), model::polarIndex(1, 1)})
    v.push_back(channel.moment[i] / det::kShLinear / 3.0);
  return v;
}

DayModes::DayModes(const DayFields& day, const ErrorGrid& grid) : DayModes(std::array{&day}, grid) {}

DayModes::DayModes(std::span<const DayFields* const> days, const ErrorGrid& grid) {
  std::vector<FieldChannel> channel;
  std::vector<double> rows;
  for (const DayFields* day : days) {
    const std::size_t apart = std::max<std::size_t>(1, day->instant.size() * 3 / kSnapshots);
    const int channels = isGrey(*day->sky) ? 1 : 3;
    for (std::size_t i = 0; i < day->instant.size(); i += apart)
      for (int c = 0; c < channels; ++c) {
        const DayInstant& at = day->instant[i];
        if (!(at.divisor[c] > 0.0)) continue;
        channel.push_back(FieldChannel().add(FieldChannel(at.field, c), at.intensity / at.divisor[c]));
        const std::vector<double> vector = vectorOf(channel.back());
        rows.insert(rows.end(), vector.begin(), vector.end());
      }
  }
  if (channel.empty()) return;

  const std::size_t dimension = rows.size() / channel.size();
  const sh::Modes leading = sh::leadingModes({rows, dimension}, {}, kBasis + kBasisMore * (days.size() - 1));
  const auto directions = sh::asRows(leading.vector, dimension);
  const sh::RowMatrix share = sh::asRows(rows, dimension) * directions.transpose();  // channel, mode
  const Eigen::VectorXd energy = share.colwise().squaredNorm();
  const Eigen::Index count = (energy.array() > 0.0).count();  // energies descend
  for (Eigen::Index k = 0; k < count; ++k) {
    // An eigenvector of the sum of snapshots times themselves is a combination of snapshots. Its whole field is the
    // same combination of their fields.
    FieldChannel mode;
    for (std::size_t j = 0; j < channel.size(); ++j) mode.add(channel[j], share(static_cast<Eigen::Index>(j), k));
    basis_.push_back(FieldChannel().add(mode, 1.0 / energy[k]));
    vector_.emplace_back(directions.row(k).begin(), directions.row(k).end());
  }
  snapshot_.resize(channel.size() * basis_.size());
  if (!basis_.empty()) sh::asRows(snapshot_, basis_.size()) = share.leftCols(count);
  std::vector<std::vector<double>> value;
  for (const FieldChannel& mode : basis_) value.push_back(grid.valuesOf(mode));
  for (std::size_t i = 0; i < grid.count(); i += kNormalsApart)
    for (const auto& of_mode : value) values_.push_back(of_mode[i]);
}

ModeSet DayModes::best(std::size_t count) const {
  ModeSet set;
  if (basis_.empty()) return set;
  const sh::RefinedModes refined =
      sh::refineModes({snapshot_, basis_.size()}, {}, count, sh::MaximumNorm{values_, {}}, kSteps);
  for (std::size_t k = 0; k < refined.modes.count(); ++k) {
    FieldChannel mode;
    std::vector<double> vector(vector_.front().size());
    for (std::size_t j = 0; j < basis_.size(); ++j) {
      const double factor = refined.modes.row(k)[j];
      mode.add(basis_[j], factor);
      sh::asVector(vector) += factor * sh::asVector(vector_[j]);
    }
    set.mode.push_back(std::move(mode));
    set.vector.push_back(std::move(vector));
  }
  return set;
}

}  // namespace welkin::table
