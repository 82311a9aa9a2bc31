#include "render/surface/color_map_table.h"

#include "render/surface/compiled_pattern.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/surface/color_map_table.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/math-inl.h"

#include <array>
#include <cstdint>
#include <span>

#ifndef FIRSTLIGHT_RENDER_SURFACE_COLOR_MAP_TABLE
#define FIRSTLIGHT_RENDER_SURFACE_COLOR_MAP_TABLE
namespace firstlight::render {
namespace {

constexpr std::size_t kChannels = 5;
constexpr std::size_t kRow = 12;  ///< numbers: kChannels colours and steps, begin, length

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// Where the rows of the places begin. Returns those that lie on an entry.
HWY_INLINE LanesMask find_rows(const Lanes& place, std::span<const double> positions,
                               std::int32_t (&first)[Lanes::kCount]) {
  const std::size_t last = positions.size() - 1;
  const LanesMask beyond = place >= positions[last];
  LanesMask open = !beyond;
  LanesMask on_entry = beyond;
  Lanes above = 0.0;
  // The last entry ends the search, even of what is no number.
  for (std::size_t i = 0; i < last && any(open); ++i) {
    on_entry = on_entry | (open & (place == positions[i]));
    open = open & (Lanes(positions[i]) < place);
    above = select(open, above + 1.0, above);
  }
  above = select(beyond, Lanes(static_cast<double>(last)), above);
  on_entry = on_entry | (above == 0.0);
  const Lanes row = select(on_entry, above + static_cast<double>(positions.size()), above) * double{kRow};
  std::int64_t numbers[Lanes::kCount];
  store_bits(row + kWholeInBits, numbers);
  for (std::size_t i = 0; i < Lanes::kCount; ++i) first[i] = static_cast<std::int32_t>(numbers[i]);
  return on_entry;
}

void look_up_all(std::span<const double> positions, const double* rows, const Column<double>& places, std::size_t count,
                 ColorColumns& colors) {
  const hn::Rebind<float, LaneTag> narrow;
  Column<float>* const channels[kChannels] = {&colors.rgb.of[0], &colors.rgb.of[1], &colors.rgb.of[2], &colors.filter,
                                              &colors.transmit};
  for (std::size_t i = 0; i < count; i += Lanes::kCount) {
    const auto place = load<Lanes>(places, i);
    std::int32_t first[Lanes::kCount];
    const LanesMask on_entry = find_rows(place, positions, first);
    Lanes row[3][4];
    for (std::size_t k = 0; k < 3; ++k) load_rows(rows + 4 * k, first, row[k]);
    const Lanes way = select(on_entry, Lanes(0.0), (place - row[2][2]) / row[2][3]);
    for (std::size_t channel = 0; channel < kChannels; ++channel) {
      const Lanes* const color = &row[channel / 2][channel % 2 * 2];
      const auto begin = hn::DemoteTo(narrow, color[0].v);
      const auto step = hn::DemoteTo(narrow, (color[1] * way).v);
      hn::StoreU(hn::Add(begin, step), narrow, &(*channels[channel])[i]);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(look_up_all);

std::array<float, kChannels> channels_of(const FilteredColor& color) {
  return {color.rgb.x, color.rgb.y, color.rgb.z, color.filter, color.transmit};
}

}  // namespace

ColorMapTable::ColorMapTable(const ColorMap& map) : rows_(2 * map.size() * kRow, 0.0) {
  for (const ColorMapEntry& entry : map) positions_.push_back(stored_position(entry.position));
  for (std::size_t i = 0; i < map.size(); ++i) {
    const auto end = channels_of(map[i].color);
    double* const entry = &rows_[(map.size() + i) * kRow];
    for (std::size_t channel = 0; channel < kChannels; ++channel) entry[2 * channel] = end[channel];
    if (i == 0) continue;
    const auto begin = channels_of(map[i - 1].color);
    double* const between = &rows_[i * kRow];
    for (std::size_t channel = 0; channel < kChannels; ++channel) {
      between[2 * channel] = begin[channel];
      between[2 * channel + 1] = end[channel] - begin[channel];
    }
    between[kRow - 2] = positions_[i - 1];
    between[kRow - 1] = positions_[i] - positions_[i - 1];
  }
}

void ColorMapTable::colors(const Column<double>& places, std::size_t count, ColorColumns& colors) const {
  HWY_DYNAMIC_DISPATCH(look_up_all)(positions_, rows_.data(), places, count, colors);
}

}  // namespace firstlight::render
#endif
