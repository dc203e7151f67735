#include "row_origin.hpp"

#include "csv_line.hpp"

namespace footprint_collision_predictor::tools {

std::string originHeader(const RowOrigin& origin) {
  return origin.footprint.empty() ? ",bag" : ",footprint,bag";
}

std::string originColumns(const RowOrigin& origin) {
  CsvLine line;
  if (!origin.footprint.empty()) line.add(origin.footprint);
  return "," + line.add(origin.bag).text();
}

}  // namespace footprint_collision_predictor::tools
