// SPDX-License-Identifier: GPL-3.0-or-later
// From a study to its runs.
#include "cases/study_runs.h"

#include "core/error.h"

#include <fmt/format.h>

#include <map>
#include <set>

namespace birdstrike {
namespace {

constexpr std::size_t most_runs = 10000;

//! Letters and digits of a label as they can stand in a folder name: "100 m/s" -> "100-m-per-s".
std::string slug_of(const std::string& label)
{
  std::string slug;
  const auto hyphen = [&] {
    if (!slug.empty() && slug.back() != '-')
      slug += '-';
  };
  for (std::size_t i = 0; i < label.size(); ++i) {
    const unsigned char c = static_cast<unsigned char>(label[i]);
    const bool digit_follows = i + 1 < label.size() && std::isdigit(static_cast<unsigned char>(label[i + 1]));
    if (std::isalnum(c)) // bytes of letters beyond ASCII are none in the C locale
      slug += static_cast<char>(std::tolower(c));
    else if (c == '.' && !slug.empty() && std::isdigit(static_cast<unsigned char>(slug.back())) &&
             digit_follows)
      slug += '.';
    else if (c == '/') {
      hyphen();
      slug += "per-";
    } else if (c == '-' && digit_follows && (slug.empty() || slug.back() == '-'))
      slug += "minus-";
    else
      hyphen();
  }
  while (!slug.empty() && slug.back() == '-')
    slug.pop_back();
  return slug;
}

Case case_of(const Study& study, const std::vector<Entry>& changes, const std::string& label)
{
  try {
    Case parsed = read_case_with(study.base, changes);
    if (!parsed.bird.mesh.empty())
      find_mesh(parsed);
    return parsed;
  } catch (const InputError& error) {
    const std::string message = error.what();
    if (message.starts_with(study.file.string()) || message.starts_with("--set"))
      throw;
    throw InputError(fmt::format("{} (in run \"{}\" of {})", message, label, study.file.string()));
  }
}

//! A key of --set would make all values of its sweep the same.
void refuse_swept(const Study& study, const Entry& override_entry)
{
  const std::string path = join(override_entry.path);
  for (const Sweep& sweep : study.sweeps)
    for (const SweepValue& value : sweep.values)
      for (const Entry& change : value.changes)
        require(join(change.path) != path,
                fmt::format(
                    "--set {}: the study sweeps this key at {}; change its values there, or pick runs with "
                    "--only",
                    path, sweep.place));
}

} // namespace

std::vector<std::string> make_slugs(const std::vector<std::vector<std::string>>& labels)
{
  constexpr std::size_t longest = 120; // file systems allow 255 bytes
  std::set<std::string> taken;
  std::vector<std::string> slugs;
  for (const std::vector<std::string>& row : labels) {
    std::string slug;
    for (const std::string& label : row)
      if (const std::string part = slug_of(label); !part.empty())
        slug += (slug.empty() ? "" : "_") + part;
    slug = slug.empty() ? "run" : slug.substr(0, longest);
    std::string name = slug;
    for (int number = 2; !taken.insert(name).second; ++number)
      name = fmt::format("{}_{}", slug, number);
    slugs.push_back(name);
  }
  return slugs;
}

std::vector<StudyRun> runs_of_study(const Study& study, const std::vector<std::string>& overrides)
{
  std::vector<Entry> common = study.set, last;
  for (const std::string& text : overrides) {
    last.push_back(parse_override(text));
    refuse_swept(study, last.back());
  }
  std::size_t count = 1;
  for (const Sweep& sweep : study.sweeps) {
    count *= sweep.values.size();
    require(count <= most_runs,
            fmt::format("{}: with this sweep the study has more than {} runs; allowed are {}", sweep.place,
                        most_runs, most_runs));
  }

  std::vector<StudyRun> runs;
  std::vector<std::vector<std::string>> labels;
  for (std::size_t number = 0; number < count; ++number) {
    StudyRun run;
    run.choice.resize(study.sweeps.size());
    std::size_t rest = number;
    for (std::size_t s = study.sweeps.size(); s-- > 0; rest /= study.sweeps[s].values.size())
      run.choice[s] = rest % study.sweeps[s].values.size();
    std::vector<Entry> changes = common;
    labels.emplace_back();
    for (std::size_t s = 0; s < study.sweeps.size(); ++s) {
      const SweepValue& value = study.sweeps[s].values[run.choice[s]];
      changes.insert(changes.end(), value.changes.begin(), value.changes.end());
      labels.back().push_back(value.label);
    }
    changes.insert(changes.end(), last.begin(), last.end());
    run.label = fmt::format("{}", fmt::join(labels.back(), ", "));
    run.parsed = case_of(study, changes, run.label);
    runs.push_back(std::move(run));
  }

  const std::vector<std::string> slugs = make_slugs(labels);
  std::map<std::string, std::string> seen; // case text -> label
  for (std::size_t k = 0; k < runs.size(); ++k) {
    runs[k].slug = slugs[k];
    const auto [same, is_new] = seen.emplace(to_toml(runs[k].parsed), runs[k].label);
    require(is_new, fmt::format("{}: the runs \"{}\" and \"{}\" are the same case; drop one of the values",
                                study.file.string(), same->second, runs[k].label));
  }
  return runs;
}

} // namespace birdstrike
