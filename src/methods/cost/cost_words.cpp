#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "toccata/methods/cost.hpp"

namespace toccata {
namespace {

std::string name_of(const CostRow& row) {
  if (row.volume == CostVolume::wide) return "the library's own tree (wide)";
  return fmt::format("{} with {} children a node by {}", name_of(row.volume), row.arity, name_of(row.method));
}

std::string time_text(double nanoseconds) {
  if (nanoseconds < 1e3) return fmt::format("{:.3g} ns", nanoseconds);
  return nanoseconds < 1e6 ? fmt::format("{:.3g} us", nanoseconds / 1e3) : fmt::format("{:.4g} ms", nanoseconds / 1e6);
}

double share(double part, double whole) { return whole > 0 ? 100 * part / whole : 0; }

std::string parts_text(const CostRow& row) {
  const double all = row.cost();
  if (row.volume == CostVolume::wide)
    return fmt::format("{:.0f} % of it for updating volumes, the rest is not taken apart",
                       share(row.update_cost(), all));
  return fmt::format("{:.0f} % of it for updating volumes, {:.0f} % for comparing them, {:.0f} % for triangles",
                     share(row.update_cost(), all), share(row.test_cost(), all), share(row.item_cost(), all));
}

std::string line_about_best(const CostRow& best) {
  return fmt::format("{}: {} a query ({} as it ran), {}", name_of(best), time_text(best.cost()),
                     time_text(best.measured_ns), parts_text(best));
}

/// "4.2 times"; empty for a ratio that rounds to 1.
std::string times_text(double ratio) {
  const std::string text = fmt::format("{:.2g}", ratio);
  return text == "1" ? "" : text + " times";
}

/// "4.2 times the tests of volumes at 0.3 times the time each", without what is the same; nothing where neither has
/// any.
void compare(std::vector<std::string>& parts, const char* what, double count, double count_of_best, double each,
             double each_of_best) {
  if (count == 0 && count_of_best == 0) return;
  if (count_of_best == 0 || count == 0) {
    parts.push_back(fmt::format("{:.6g} instead of {:.6g} {}", count, count_of_best, what));
    return;
  }
  const std::string counts = times_text(count / count_of_best);
  const std::string times = times_text(each_of_best > 0 ? each / each_of_best : 1);
  if (counts.empty() && times.empty()) return;
  parts.push_back((counts.empty() ? "as many " : counts + " the ") + what +
                  (times.empty() ? "" : " at " + times + " the time each"));
}

std::string comparison(const CostRow& other, const CostRow& best) {
  std::vector<std::string> parts;
  const auto number = [](std::size_t count, const CostRow& row) {
    return static_cast<double>(count) / static_cast<double>(row.queries);
  };
  compare(parts, "updates", number(other.counts.volumes_updated, other), number(best.counts.volumes_updated, best),
          other.update_ns, best.update_ns);
  compare(parts, "tests of volumes", number(other.counts.volume_tests, other), number(best.counts.volume_tests, best),
          other.test_ns, best.test_ns);
  compare(parts, "triangle pairs", number(other.counts.items, other), number(best.counts.items, best), other.item_ns,
          best.item_ns);
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// Empty for a row that costs about the same.
std::string line_about(const CostRow& other, const CostRow& best) {
  if (other.cost() == best.cost()) return "";
  std::string factor = time_text(other.cost());
  if (best.cost() > 0) {
    const std::string times = times_text(other.cost() / best.cost());
    if (times.empty()) return "";
    factor = times + " as much";
  }
  const std::string reasons = comparison(other, best);
  return fmt::format("{} costs {}{}{}", name_of(other), factor, reasons.empty() ? "" : ": ", reasons);
}

using CostRows = std::vector<const CostRow*>;

/// The cheapest rows of other volumes than the best, and of other hierarchies over the same; each once.
CostRows rivals(const CostRows& rows) {
  const CostRow& best = *rows.front();
  CostRows found;
  const auto add = [&](const auto& differs) {
    const auto row = std::find_if(rows.begin(), rows.end(), differs);
    if (row != rows.end() && std::find(found.begin(), found.end(), *row) == found.end()) found.push_back(*row);
  };
  std::vector<CostVolume> seen{best.volume};
  for (int i = 0; i < 2; ++i) {
    add([&](const CostRow* row) { return std::find(seen.begin(), seen.end(), row->volume) == seen.end(); });
    if (!found.empty()) seen.push_back(found.back()->volume);
  }
  add([&](const CostRow* row) { return row->volume == best.volume && row->arity != best.arity; });
  add([&](const CostRow* row) { return row->volume == best.volume && row->method != best.method; });
  return found;
}

}  // namespace

std::vector<std::string> explain_winner(const CostTable& table, CostWorkload workload) {
  CostRows rows;
  for (const CostRow& row : table.rows)
    if (row.workload == workload) rows.push_back(&row);
  if (rows.empty()) return {};
  std::vector<std::string> lines{"the cheapest is " + line_about_best(*rows.front())};
  const auto is_wide = [](const CostRow* row) { return row->volume == CostVolume::wide; };
  CostRows plain = rows;
  std::erase_if(plain, is_wide);
  if (is_wide(rows.front()) && !plain.empty())
    lines.push_back("of the plain trees the cheapest is " + line_about_best(*plain.front()));
  if (!plain.empty())
    for (const CostRow* rival : rivals(plain))
      if (std::string line = line_about(*rival, *plain.front()); !line.empty()) lines.push_back(std::move(line));
  const CostRow& fastest = **std::min_element(
      rows.begin(), rows.end(), [](const CostRow* x, const CostRow* y) { return x->measured_ns < y->measured_ns; });
  if (&fastest != rows.front())
    lines.push_back(fmt::format("as they ran, walk and all, the fastest was {}: {} a query", name_of(fastest),
                                time_text(fastest.measured_ns)));
  return lines;
}

}  // namespace toccata
