// SPDX-License-Identifier: Apache-2.0
#include "study/level_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "probes/build/level_bake.h"
#include "probes/build/surface_budget.h"
#include "probes/certify/level_certificate.h"
#include "sky/base/error.h"
#include "study/pareto.h"

namespace welkin::study {
namespace {

/// One way to bake a level.
struct Way {
  std::string name;
  double spread = 1.0;
  bool is_spread = true;  ///< differs in its spread alone
  build::BakeSection section;
};

/// A way that was baked.
struct Measured {
  Way way;
  std::size_t probes = 0, bytes = 0;
  double seconds = 0.0;
  certify::LevelCertificate error;
};

std::vector<Way> waysOf(const build::BakeSection& section, bool quick) {
  std::vector<Way> ways;
  for (const double spread : build::kSpreads)
    if (!quick || spread == build::kSpreads.front() || spread == 1.0)
      ways.push_back({fmt::format("distances x {:g}", spread), spread, true, section});
  const auto add = [&](const char* name, auto&& change) {
    ways.push_back({name, 1.0, false, section});
    change(ways.back().section);
  };
  add("without fit", [](build::BakeSection& s) { s.transfer.fit = build::Fit::none; });
  if (quick) return ways;
  add("walls ignored", [](build::BakeSection& s) { s.probes.walls = placement::Walls::ignore; });
  add("sun as sh", [](build::BakeSection& s) { s.transfer.sun = transfer::SunTransfer::sh; });
  add("one bounce", [](build::BakeSection& s) { s.transfer.bounces = std::min(s.transfer.bounces, 1); });
  return ways;
}

certify::CertifySettings settingsOf(const build::BakeSection& section, bool quick) {
  certify::CertifySettings settings{256, 128, 128, section.transfer.bounces, !quick};
  if (quick) settings.surface_points = settings.air_points = 48;
  return settings;
}

Measured measure(const build::Subject& subject, const Way& way, const certify::CertifySettings& settings,
                 const base::Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const build::LevelBake level(subject.level->surfaces, way.section, subject.sky.sky, subject.sky.bake.max_error,
                               progress);
  if (level.sectors().empty())
    throw base::Error(base::ExitStatus::content, "the level has no sectors, so there is nothing to study");
  Measured result{way, 0, 0, 0.0, {}};
  std::vector<sectors::SectorFile> files;
  for (const geometry::SectorId sector : level.sectors()) {
    files.push_back(level.bake(sector, progress, way.spread));
    result.probes += files.back().probes.probes();
    result.bytes += sectors::encodeSector(files.back()).size();
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const geometry::Tracer tracer(level.surfaces());
  result.error = certify::certifyLevel(tracer, subject.sky.sky, files, settings, progress);
  return result;
}

double surface(const Measured& m) {
  return m.error.surface.total.rms;
}

double air(const Measured& m) {
  return m.error.air.total.rms;
}

Table tableOf(const std::vector<Measured>& measured) {
  Table table({{"way"},
               {"probes"},
               {"bytes", "bytes", Quantity::bytes},
               {"bake", "s", Quantity::seconds},
               {"surface_sky", "", Quantity::share},
               {"surface_sun", "", Quantity::share},
               {"surface_total", "", Quantity::share},
               {"surface_interval", "", Quantity::share},
               {"air_total", "", Quantity::share},
               {"air_interval", "", Quantity::share}});
  for (const Measured& m : measured)
    table.addRow({m.way.name, static_cast<double>(m.probes), static_cast<double>(m.bytes), m.seconds,
                  m.error.surface.sky.rms, m.error.surface.sun_bounce.rms, surface(m), m.error.surface.total.interval,
                  air(m), m.error.air.total.interval});
  return table;
}

/// The measured ways that none beats in bytes and error, fewest bytes first.
std::vector<std::size_t> frontOf(const std::vector<Measured>& measured) {
  std::vector<Tradeoff> tradeoffs;
  for (const Measured& m : measured) tradeoffs.push_back({static_cast<double>(m.bytes), std::max(surface(m), air(m))});
  return paretoFront(tradeoffs);
}

Chart chartOf(const std::vector<Measured>& measured, const std::vector<std::size_t>& front) {
  Chart chart;
  chart.title = "Bytes of probes against error on surfaces and in the air";
  chart.x = {"bytes of all sectors", Quantity::bytes, Scale::log};
  chart.y = {"rms error, share of the open sky", Quantity::share, Scale::log};
  Series on_surfaces{"surfaces", SeriesStyle::line, {}}, in_air{"air", SeriesStyle::line, {}};
  Series others{"other ways, surfaces", SeriesStyle::markers, {}};
  Series best{"front, the worse of both", SeriesStyle::front, {}};
  for (const Measured& m : measured) {
    const auto bytes = static_cast<double>(m.bytes);
    if (!m.way.is_spread) {
      others.points.push_back({bytes, surface(m), m.way.name});
      continue;
    }
    on_surfaces.points.push_back({bytes, surface(m), m.way.name});
    in_air.points.push_back({bytes, air(m)});
  }
  for (const std::size_t i : front)
    best.points.push_back({static_cast<double>(measured[i].bytes), std::max(surface(measured[i]), air(measured[i]))});
  chart.series = {on_surfaces, in_air, others, best};
  const certify::RmsError& nothing = measured.front().error.surface.nothing;
  chart.lines = {{nothing.rms, "surfaces without light"}};
  return chart;
}

std::vector<std::string> conclusionOf(const std::vector<Measured>& measured, const std::vector<std::size_t>& front) {
  std::vector<std::string> text;
  std::string list;
  for (const std::size_t i : front) {
    const Measured& m = measured[i];
    list += fmt::format("{}{} by {} ({} probes)", list.empty() ? "" : ", ", share(std::max(surface(m), air(m))),
                        inWords(static_cast<double>(m.bytes), Quantity::bytes, 3) + " of " + m.way.name, m.probes);
  }
  text.push_back(fmt::format("The fewest bytes for an error, the worse of surfaces and air: {}.", list));
  const auto stated = std::find_if(measured.begin(), measured.end(),
                                   [](const Measured& m) { return m.way.is_spread && m.way.spread == 1.0; });
  const auto plain = std::find_if(measured.begin(), measured.end(), [](const Measured& m) {
    return m.way.section.transfer.fit == build::Fit::none && !m.way.is_spread;
  });
  if (stated != measured.end() && plain != measured.end())
    text.push_back(fmt::format("The fit takes the error on surfaces from {} to {}, for {:+} bytes.",
                               share(surface(*plain)), share(surface(*stated)),
                               static_cast<long long>(stated->bytes) - static_cast<long long>(plain->bytes)));
  text.push_back(fmt::format("`welkin bake --max-surface-error {:.2g}` searches between these for each sector.",
                             std::max(surface(measured[front.back()]), air(measured[front.back()])) * 1.1));
  return text;
}

}  // namespace

std::size_t levelWays(bool quick) {
  return waysOf({}, quick).size();
}

StudyReport studyLevel(const build::Subject& subject, const LevelStudyOptions& options) {
  build::BakeSection section = subject.level->section;
  section.max_surface_error.reset();
  const certify::CertifySettings settings = settingsOf(section, options.quick);
  std::vector<Measured> measured;
  for (const Way& way : waysOf(section, options.quick)) {
    measured.push_back(measure(subject, way, settings, options.progress.stage(way.name, 0)));
    options.progress.step();
  }
  const std::vector<std::size_t> front = frontOf(measured);
  StudyReport report;
  report.title = "Bytes against error: the probes of " + subject.inputs.at(subject.sky.inputs.size()).name;
  report.paragraphs = conclusionOf(measured, front);
  report.charts.push_back({"level", chartOf(measured, front)});
  report.tables.push_back({"level", "Ways to bake the level", tableOf(measured)});
  return report;
}

}  // namespace welkin::study
