// SPDX-License-Identifier: BSD-3-Clause
// A VTK table as a CSV file.
#include "vtkio/table_to_csv.h"

#include "vtkio/atomic_file.h"

#include <vtkDataArray.h>
#include <vtkTable.h>

#include <fmt/format.h>

#include <cmath>

namespace birdstrike {

namespace {

// RFC 4180: quotes around what would otherwise break the line into other cells.
std::string quoted(const std::string& text)
{
  if (text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string result = "\"";
  for (const char c : text)
    result += c == '"' ? std::string("\"\"") : std::string(1, c);
  result += '"';
  return result;
}

std::string cell(vtkTable& table, vtkIdType row, vtkIdType column)
{
  auto* numbers = vtkDataArray::SafeDownCast(table.GetColumn(column));
  if (!numbers)
    return quoted(table.GetValue(row, column).ToString());
  const double value = numbers->GetComponent(row, 0);
  return std::isnan(value) ? "" : fmt::format("{}", value);
}

} // namespace

void write_csv(vtkTable& table, const std::filesystem::path& file)
{
  std::string text;
  for (vtkIdType column = 0; column < table.GetNumberOfColumns(); ++column)
    (text += column > 0 ? "," : "") += quoted(table.GetColumnName(column));
  text += '\n';
  for (vtkIdType row = 0; row < table.GetNumberOfRows(); ++row) {
    for (vtkIdType column = 0; column < table.GetNumberOfColumns(); ++column)
      (text += column > 0 ? "," : "") += cell(table, row, column);
    text += '\n';
  }
  write_text_atomically(file, text);
}

} // namespace birdstrike
