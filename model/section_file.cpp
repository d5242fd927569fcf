// SPDX-License-Identifier: MIT
#include "model/section_file.h"

#include "csg/base/error.h"
#include "csg/file/whole_file.h"
#include "measure/section_json.h"
#include "measure/section_svg.h"
#include "model/section_image.h"
#include "shade/picture/image_file.h"

namespace csgcast {
namespace {

void write_text(const std::string& text, const std::string& path) {
  WholeFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace

void write_section(const Scene& scene, const Plane& plane, const Section& section, const std::string& path,
                   int pixels) {
  if (path.ends_with(".svg")) return write_text(section_svg(section, unseen_tolerance(section)), path);
  if (path.ends_with(".json")) return write_text(section_json(section), path);
  if (path.ends_with(".png")) return write_image(section_image(scene, plane, section, pixels), path);
  throw Error(ErrorCode::usage, {path, 0, 0}, "not a known kind of file for a section", "",
              "known endings are .svg, .json and .png");
}

}  // namespace csgcast
