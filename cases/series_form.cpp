// SPDX-License-Identifier: GPL-3.0-or-later
// The words by which a series' form is told, in case files and on the command line.
#include "cases/series_form.h"

#include "core/fields.h"

#include <algorithm>

namespace birdstrike {

std::vector<std::string> series_formats() { return {"vtu", "packed", "both"}; }
std::vector<std::string> series_precisions() { return {"single", "double"}; }
std::vector<std::string> series_compressions() { return {"none", "lz4", "zlib", "lzma"}; }

std::vector<std::string> series_fields()
{
  std::vector<std::string> names{"displacement"};
  const auto add = [&names](const auto& fields) {
    for (const auto& field : fields)
      if (std::find(names.begin(), names.end(), field.name) == names.end())
        names.emplace_back(field.name);
  };
  add(particle_fields);
  add(target_fields);
  add(mesh_target_fields);
  add(shell_fields);
  return names;
}

SeriesOptions series_options(const SeriesForm& form)
{
  const auto compressions = series_compressions();
  SeriesOptions options;
  options.vtu = form.format != "packed";
  options.packed = form.format != "vtu";
  options.single_precision = form.precision == "single";
  options.compression = static_cast<Compression>(
      std::find(compressions.begin(), compressions.end(), form.compression) - compressions.begin());
  options.accuracy = form.accuracy;
  options.fields = form.fields;
  return options;
}

} // namespace birdstrike
