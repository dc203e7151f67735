#include "report_page.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "csv_line.hpp"
#include "findings.hpp"
#include "marker_style.hpp"
#include "report_assets.hpp"
#include "summary.hpp"

namespace footprint_collision_predictor::tools {
namespace {

using Json = nlohmann::ordered_json;

// Rows of the table of events, at most; events.csv has them all.
constexpr std::size_t kMostEvents = 2000;

constexpr char kOnlyPage[] = "report.html";

/// JSON for a script element, which ends at the first "</script" whatever stands before it.
std::string scriptText(const Json& json) {
  std::string safe;
  for (const char c : json.dump(-1, ' ', true, Json::error_handler_t::replace))
    safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return safe;
}

/// By the names of the levels and of what else is drawn.
Json stylesJson() {
  const auto json = [](Outlook outlook) -> Json {
    const Style& s = styleOf(outlook);
    return {
        {"rgb", {s.red, s.green, s.blue}}, {"width", s.width}, {"dash", s.dash}, {"gap", s.gap}};
  };
  return {{"irrelevant", json(Outlook::kIrrelevant)},
          {"free", json(Outlook::kFree)},
          {"later", json(Outlook::kLater)},
          {"unknown", json(Outlook::kUnknown)},
          {"warn", json(Outlook::kWarn)},
          {"critical", json(Outlook::kCritical)}};
}

Json reasonNames() {
  Json names;
  for (std::uint32_t bit = 1; bit != 0; bit <<= 1) names[std::to_string(bit)] = reasonName(bit);
  return names;
}

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// As text: JavaScript would round a large one.
Json idOrNull(std::int64_t id) { return id < 0 ? Json(nullptr) : Json(std::to_string(id)); }

Json eventJson(const Event& event) {
  return {{"begin", event.begin},
          {"end", event.end},
          {"worst", event.worst.elapsed},
          {"stamp", CsvLine().add(event.worst.stamp).text()},
          {"level", event.level},
          {"time_to_collision", event.worst.time_to_collision},
          {"segment", event.worst.segment},
          {"obstacle_id", idOrNull(event.worst.obstacle_id)},
          {"obstacle_index", idOrNull(event.worst.obstacle_index)},
          {"closing_speed", finite(event.worst.closing_speed)},
          {"closest_distance", finite(event.closest_distance)},
          {"contact", event.contact},
          {"ended", wordFor(event.ended)}};
}

/// The nearest ones, in the order of time.
std::vector<Event> shown(std::vector<Event> events) {
  if (events.size() <= kMostEvents) return events;
  std::stable_sort(events.begin(), events.end(), [](const Event& a, const Event& b) {
    return a.worst.time_to_collision < b.worst.time_to_collision;
  });
  events.resize(kMostEvents);
  std::stable_sort(events.begin(), events.end(),
                   [](const Event& a, const Event& b) { return a.begin < b.begin; });
  return events;
}

Json eventsJson(const std::vector<Event>& events) {
  Json json = Json::array();
  for (const Event& event : shown(events)) json.push_back(eventJson(event));
  return json;
}

Json levelsJson(const std::vector<LevelRun>& levels) {
  Json json = Json::array();
  for (const LevelRun& run : levels) json.push_back({run.begin, run.level});
  return json;
}

Json describe(const BagReport& report, const Film& film, const Options& options,
              const Parameters& parameters) {
  Json json;
  json["program"] = "analyze_bag " PACKAGE_VERSION;
  json["verdict"] = verdictText(report, options);
  json["bag"] = bagJson(report, options);
  json["parameters"] = parametersJson(parameters);
  json["max_unknown"] = options.max_unknown;
  json["fail_under"] = options.fail_under ? Json(*options.fail_under) : Json(nullptr);
  json["window_seconds"] = (report.window.end - report.window.begin).toSec();
  json["several"] = report.page != kOnlyPage;
  json["thinned"] = film.isThinned();
  json["styles"] = stylesJson();
  json["reason_names"] = reasonNames();
  json["unknown_reasons"] =
      (kFirstDegradedReason - 1) & ~std::uint32_t{CollisionWarning::REASON_SETTLING};
  json["events"] = eventsJson(report.events);
  json["levels"] = levelsJson(film.levels());
  return json;
}

}  // namespace

std::string pageName(const BagReport& report, std::size_t index, std::size_t count) {
  if (count == 1) return kOnlyPage;
  std::string stem = std::filesystem::path(report.bag).stem().string().substr(0, 100);
  if (!report.footprint.empty()) stem += "_" + report.footprint.substr(0, 100);
  for (char& c : stem)  // for links and any file system
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
  char number[32];
  std::snprintf(number, sizeof number, "%04zu_", index + 1);
  return "reports/" + (number + stem) + ".html";
}

void writeReport(const BagReport& report, const Film& film, const Options& options,
                 const Parameters& parameters, std::ostream& out) {
  const PageText page = reportPage();
  std::string described = scriptText(describe(report, film, options, parameters));
  described.pop_back();  // the brace, since the frames belong into it
  out << page.before_data << described << ",\"frames\":[";
  const char* separator = "";
  film.forEach([&](const std::string& frame) {
    out << separator << frame;
    separator = ",\n";
  });
  out << "]}" << page.after_data;
}

void writeReportList(const std::vector<BagReport>& reports, const Options& options,
                     std::ostream& out) {
  Json json;
  json["program"] = "analyze_bag " PACKAGE_VERSION;
  json["styles"] = stylesJson();
  json["bags"] = Json::array();
  for (const BagReport& report : reports) {
    json["bags"].push_back(bagJson(report, options));
    json["bags"].back()["verdict"] = verdictText(report, options);
    json["bags"].back()["page"] = report.page;
  }
  const PageText page = reportListPage();
  out << page.before_data << scriptText(json) << page.after_data;
}

}  // namespace footprint_collision_predictor::tools
