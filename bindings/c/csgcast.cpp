// SPDX-License-Identifier: MIT
#include "bindings/c/csgcast.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "csg/base/error.h"
#include "csg/solid/parts.h"
#include "csg/text/statement/builder.h"
#include "csg/text/syntax/reader.h"
#include "measure/section_json.h"
#include "measure/section_polylines.h"
#include "measure/section_svg.h"
#include "model/model.h"
#include "model/section_file.h"
#include "raycast/packets/threads.h"
#include "shade/picture/image_file.h"

struct csgcast_model {
  csgcast::Model model;
};

namespace {

using namespace csgcast;

thread_local std::string last_error;
thread_local std::string last_leaf_name;
thread_local int threads_of_calls = 0;

/// No exception leaves a C function.
template <class Call>
csgcast_status guarded(Call&& call) {
  last_error.clear();
  try {
    on_threads(threads_of_calls, call);
    return CSGCAST_OK;
  } catch (const Cancelled& cancelled) {
    last_error = cancelled.what();
    return CSGCAST_CANCELLED;
  } catch (const Error& error) {
    last_error = error.what();
    return error.code() == ErrorCode::machine ? CSGCAST_FAILED : CSGCAST_BAD_INPUT;
  } catch (const std::bad_alloc&) {
    last_error = "error: out of memory";
  } catch (const std::exception& error) {
    last_error = error.what();
  }
  return CSGCAST_FAILED;
}

void require(bool holds, const char* what) {
  if (!holds) throw Error(ErrorCode::usage, {}, what, "there is nothing to work with", "give a pointer to something");
}

/// What was given, with the defaults for what its program does not know.
template <class Options>
Options completed(const Options* given, const Options& defaults) {
  if (given == nullptr) return defaults;
  constexpr std::size_t least = offsetof(Options, size) + sizeof(given->size);
  if (given->size <= least)
    throw Error(ErrorCode::usage, {}, "the size of the options is not set", "",
                "begin with the macro CSGCAST_.._OPTIONS");
  const auto* bytes = reinterpret_cast<const unsigned char*>(given);
  if (std::any_of(bytes + std::min(given->size, sizeof(Options)), bytes + given->size,
                  [](unsigned char byte) { return byte != 0; })) {
    throw Error(ErrorCode::usage, {}, "an option that this version of csgcast does not know", "",
                "leave it zero, or use the version that the program was built with");
  }
  Options options = defaults;
  std::memcpy(&options, given, std::min(given->size, sizeof(Options)));
  return options;
}

text::Facets facets_of(csgcast_facets facets) {
  switch (facets) {
    case CSGCAST_FACETS_AUTO:
      return text::Facets::automatic;
    case CSGCAST_FACETS_ALWAYS:
      return text::Facets::always;
    case CSGCAST_FACETS_NEVER:
      return text::Facets::never;
    case CSGCAST_FACETS_INT:
      break;
  }
  throw Error(ErrorCode::usage, {}, "facets has none of its values", "", "give one of CSGCAST_FACETS_..");
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

Solid selected(Solid solid, const csgcast_options& options) {
  if (options.parts == nullptr) return solid;
  std::vector<std::string> names;
  for (size_t i = 0; i < options.part_count; ++i) {
    require(options.parts[i] != nullptr, "the name of a part is NULL");
    names.emplace_back(options.parts[i]);
  }
  const std::vector<std::string> known = part_names(solid);
  if (const std::string* name = unknown_part(known, names)) {
    throw Error(ErrorCode::unknown_name, {}, "no part is named '" + *name + "'", "",
                known.empty() ? "the scene has no parts" : "the parts are " + joined(known));
  }
  return only_parts(solid, names);
}

csgcast_model* made_of(text::Document document, const csgcast_options* given) {
  const csgcast_options options = completed<csgcast_options>(given, CSGCAST_OPTIONS);
  const Welding welding = options.weld == -1  ? Welding::derived()
                          : options.weld == 0 ? Welding{}
                                              : Welding::by_hand(options.weld);
  SceneDescription description =
      text::build(std::move(document), {facets_of(options.facets), options.skip_unsupported != 0});
  description.solid = selected(std::move(description.solid), options);
  return std::make_unique<csgcast_model>(csgcast_model{Model(std::move(description), welding)}).release();
}

Rays rays_of(size_t count, const double* origins, const double* directions) {
  require(count == 0 || (origins != nullptr && directions != nullptr), "the origins or the directions are NULL");
  return {{origins, 3 * count}, {directions, 3 * count}};
}

ProgressCallback callback_of(const csgcast_monitor* monitor) {
  if (monitor == nullptr || monitor->progress == nullptr) return {};
  return [monitor = *monitor](const Progress& now) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const csgcast_progress progress{now.share, now.relative_error.value_or(none)};
    return monitor.progress(&progress, monitor.data) != 0;
  };
}

QueryOptions between(double t_min, double t_max, const csgcast_monitor* monitor) {
  QueryOptions options;
  options.span = {t_min, t_max};
  options.progress = callback_of(monitor);
  return options;
}

csgcast_measures as_c(const Measures& m) {
  csgcast_measures result{};
  result.is_bounded = m.is_bounded ? 1 : 0;
  result.is_as_asked = m.is_as_asked ? 1 : 0;
  result.volume = m.volume.value;
  result.volume_error = m.volume.error;
  result.area = m.area.value;
  result.area_error = m.area.error;
  result.mass = m.mass.value;
  result.mass_error = m.mass.error;
  for (std::size_t i = 0; i < 3; ++i) {
    result.centroid[i] = m.centroid[i];
    result.lower[i] = m.bounds.lower[i];
    result.upper[i] = m.bounds.upper[i];
    result.principal_moments[i] = m.principal_moments[i];
    result.principal_angles[i] = m.principal_angles[i];
    for (std::size_t k = 0; k < 3; ++k) result.principal_axes[3 * i + k] = m.principal_axes[i][k];
  }
  for (std::size_t i = 0; i < 6; ++i) result.inertia[i] = m.inertia[i];
  result.centroid_error = m.centroid_error;
  result.inertia_error = m.inertia_error;
  result.principal_error = m.principal_error;
  result.bounds_error = m.bounds_error;
  return result;
}

SceneMeasures measured(const csgcast_model* model, double relative_error, double area_error,
                       const csgcast_monitor* monitor, const csgcast_measures* result) {
  require(model != nullptr && result != nullptr, "the model or the place for the result is NULL");
  MeasureOptions options;
  options.relative_error = relative_error;
  options.relative_area_error = area_error;
  options.progress = callback_of(monitor);
  return model->model.measure(options);
}

template <class Tag>
void put(const Triple<Tag>& t, double* numbers) {
  for (std::size_t axis = 0; axis < 3; ++axis) numbers[axis] = t[axis];
}

/// A section, and what was made of it.
struct SectionMemory {
  Plane plane;
  Section section;
  std::vector<std::size_t> offsets{0};
  std::vector<csgcast_arc> arcs;
  std::string text;
  std::vector<std::size_t> line_offsets;
  std::vector<double> line_points;
};

SectionMemory& memory_of(const csgcast_section* section) {
  require(section != nullptr && section->memory != nullptr, "the section is NULL, or was freed");
  return *static_cast<SectionMemory*>(section->memory);
}

void list_arcs(SectionMemory& memory) {
  for (const SectionLoop& loop : memory.section.loops) {
    for (const SectionArc& arc : loop) {
      csgcast_arc& c = memory.arcs.emplace_back();
      std::copy(arc.conic.begin(), arc.conic.end(), c.conic);
      for (const auto& [point, numbers] : {std::pair(&arc.from, c.from), {&arc.middle, c.middle}, {&arc.to, c.to}}) {
        numbers[0] = point->u;
        numbers[1] = point->v;
      }
      c.surface = arc.surface.index();
    }
    memory.offsets.push_back(memory.arcs.size());
  }
}

/// What a report points into.
struct ReportMemory {
  std::vector<csgcast_overlap> overlaps;
  std::vector<csgcast_contact> contacts;
  std::vector<std::uint32_t> unbounded, empty;
  std::vector<std::string> names;
  std::vector<csgcast_redundancy> redundancies;
};

std::vector<std::uint32_t> numbers_of(const std::vector<PartId>& parts) {
  std::vector<std::uint32_t> numbers(parts.size());
  std::transform(parts.begin(), parts.end(), numbers.begin(), [](PartId part) { return part.index(); });
  return numbers;
}

std::unique_ptr<ReportMemory> listed(const Scene& scene, const CheckReport& report) {
  auto memory = std::make_unique<ReportMemory>();
  for (const Overlap& o : report.overlaps) {
    csgcast_overlap& c = memory->overlaps.emplace_back();
    c = {o.first.index(), o.second.index(), o.volume.value, o.volume.error, {}};
    put(o.witness, c.place);
  }
  for (const Contact& c : report.undecided) memory->contacts.push_back({c.first.index(), c.second.index(), c.most});
  memory->unbounded = numbers_of(report.unbounded);
  memory->empty = numbers_of(report.empty);
  for (const Redundancy& r : report.redundant) memory->names.push_back(name_of(scene, r));
  for (std::size_t i = 0; i < report.redundant.size(); ++i) {
    const Redundancy& r = report.redundant[i];
    memory->redundancies.push_back({memory->names[i].c_str(), reason(r.why), r.first_leaf, r.leaf_end});
  }
  return memory;
}

bool is_mode(csgcast_mode mode) { return mode >= CSGCAST_SHADED && mode <= CSGCAST_ID; }

CameraDescription camera_from(const csgcast_camera& c) {
  CameraDescription camera;
  camera.eye = {c.eye[0], c.eye[1], c.eye[2]};
  camera.look_at = {c.look_at[0], c.look_at[1], c.look_at[2]};
  camera.up = {c.up[0], c.up[1], c.up[2]};
  camera.fov = c.fov;
  if (c.height != 0) camera.height = c.height;
  return camera;
}

LightDescription light_from(const csgcast_light& c) {
  LightDescription light;
  if (c.is_directional != 0) {
    light.direction = Vector{c.place[0], c.place[1], c.place[2]};
  } else {
    light.position = Point{c.place[0], c.place[1], c.place[2]};
  }
  light.color = {c.color[0], c.color[1], c.color[2]};
  light.intensity = c.intensity;
  if (c.falloff != 0) light.falloff = c.falloff;
  return light;
}

Film picture(const csgcast_model* model, const csgcast_render_options& options, const csgcast_monitor* monitor) {
  if (!is_mode(options.mode))
    throw Error(ErrorCode::usage, {}, "mode has none of its values", "", "give CSGCAST_SHADED or another of them");
  RenderOptions job;
  job.width = options.width;
  job.height = options.height;
  job.samples = options.samples;
  job.mode = static_cast<Mode>(options.mode);
  job.sampling = options.is_adaptive != 0 ? Sampling::adaptive : Sampling::regular;
  job.progress = callback_of(monitor);
  ViewChange change;
  if (options.camera != nullptr) change.camera = camera_from(*options.camera);
  if (options.lights != nullptr) change.lights.emplace();
  for (size_t i = 0; options.lights != nullptr && i < options.light_count; ++i)
    change.lights->push_back(light_from(options.lights[i]));
  if (const double* b = options.background) change.background = Rgb{b[0], b[1], b[2]};
  const double aspect = static_cast<double>(job.width) / std::max(job.height, 1);
  return model->model.render(model->model.view(aspect, change), job);
}

const Part* part_of(const csgcast_model* model, size_t part) {
  return model != nullptr && part < model->model.scene().parts().size() ? &model->model.scene().parts()[part] : nullptr;
}

}  // namespace

extern "C" {

const char* csgcast_last_error(void) { return last_error.c_str(); }

const char* csgcast_version(void) { return CSGCAST_VERSION; }

csgcast_status csgcast_load(const char* path, csgcast_model** model) { return csgcast_load_with(path, nullptr, model); }

csgcast_status csgcast_load_with(const char* path, const csgcast_options* options, csgcast_model** model) {
  return guarded([&] {
    if (model != nullptr) *model = nullptr;
    require(path != nullptr && model != nullptr, "the path or the place for the model is NULL");
    *model = made_of(text::read_file(path), options);
  });
}

csgcast_status csgcast_read(const char* text, size_t length, const char* name, csgcast_model** model) {
  return csgcast_read_with(text, length, name, nullptr, model);
}

csgcast_status csgcast_read_with(const char* text, size_t length, const char* name, const csgcast_options* options,
                                 csgcast_model** model) {
  return guarded([&] {
    if (model != nullptr) *model = nullptr;
    require(text != nullptr && name != nullptr && model != nullptr,
            "the text, its name or the place for the model is NULL");
    *model = made_of(text::read({text, length}, name), options);
  });
}

void csgcast_free(csgcast_model* model) { delete model; }

size_t csgcast_part_count(const csgcast_model* model) {
  return model != nullptr ? model->model.scene().parts().size() : 0;
}

const char* csgcast_part_name(const csgcast_model* model, size_t part) {
  const Part* found = part_of(model, part);
  return found != nullptr ? found->name.name.c_str() : nullptr;
}

double csgcast_part_density(const csgcast_model* model, size_t part) {
  const Part* found = part_of(model, part);
  return found != nullptr ? found->name.density : std::numeric_limits<double>::quiet_NaN();
}

csgcast_status csgcast_cast(const csgcast_model* model, size_t rays, const double* origins, const double* directions,
                            double t_min, double t_max, const csgcast_monitor* monitor, csgcast_intervals* result) {
  return guarded([&] {
    require(model != nullptr && result != nullptr, "the model or the place for the result is NULL");
    *result = {};
    QueryOptions options = between(t_min, t_max, monitor);
    options.faces = options.normals = true;
    auto table = std::make_unique<IntervalTable>(model->model.intervals(rays_of(rays, origins, directions), options));
    *result = {rays,
               table->count(),
               table->offsets.data(),
               table->t.data(),
               table->surfaces.data(),
               table->leaves.data(),
               table->parts.data(),
               table->normals.data(),
               table.get()};
    static_cast<void>(table.release());
  });
}

void csgcast_free_intervals(csgcast_intervals* result) {
  if (result == nullptr) return;
  delete static_cast<IntervalTable*>(result->memory);
  *result = {};
}

csgcast_status csgcast_first_hits(const csgcast_model* model, size_t rays, const double* origins,
                                  const double* directions, double t_min, double t_max, const csgcast_monitor* monitor,
                                  double* t, uint32_t* surfaces, uint8_t* is_entry) {
  return guarded([&] {
    require(model != nullptr && (rays == 0 || t != nullptr), "the model or the place for t is NULL");
    const HitTable hits = model->model.first_hits(rays_of(rays, origins, directions), between(t_min, t_max, monitor));
    std::copy(hits.t.begin(), hits.t.end(), t);
    if (surfaces != nullptr) std::copy(hits.surfaces.begin(), hits.surfaces.end(), surfaces);
    if (is_entry != nullptr) std::copy(hits.is_entry.begin(), hits.is_entry.end(), is_entry);
  });
}

csgcast_status csgcast_any_hits(const csgcast_model* model, size_t rays, const double* origins,
                                const double* directions, double t_min, double t_max, const csgcast_monitor* monitor,
                                uint8_t* result) {
  return guarded([&] {
    require(model != nullptr && (rays == 0 || result != nullptr), "the model or the place for the result is NULL");
    const auto hits = model->model.any_hits(rays_of(rays, origins, directions), between(t_min, t_max, monitor));
    std::copy(hits.begin(), hits.end(), result);
  });
}

csgcast_status csgcast_thickness(const csgcast_model* model, size_t rays, const double* origins,
                                 const double* directions, const csgcast_monitor* monitor, double* result) {
  return guarded([&] {
    require(model != nullptr && (rays == 0 || result != nullptr), "the model or the place for the result is NULL");
    const auto found = model->model.thickness(rays_of(rays, origins, directions), between(0, HUGE_VAL, monitor));
    std::copy(found.begin(), found.end(), result);
  });
}

csgcast_status csgcast_locate(const csgcast_model* model, size_t points, const double* coordinates,
                              const csgcast_monitor* monitor, int8_t* result) {
  return guarded([&] {
    require(model != nullptr, "the model is NULL");
    require(points == 0 || (coordinates != nullptr && result != nullptr),
            "the points or the place for the result is NULL");
    const std::vector<Location> found =
        model->model.locate({coordinates, 3 * points}, {.progress = callback_of(monitor)});
    std::transform(found.begin(), found.end(), result, sign_of);
  });
}

csgcast_status csgcast_measure(const csgcast_model* model, double relative_error, double area_error,
                               const csgcast_monitor* monitor, csgcast_measures* result) {
  return guarded([&] { *result = as_c(measured(model, relative_error, area_error, monitor, result).whole); });
}

csgcast_status csgcast_measure_parts(const csgcast_model* model, double relative_error, double area_error,
                                     const csgcast_monitor* monitor, csgcast_measures* result) {
  return guarded([&] {
    const SceneMeasures found = measured(model, relative_error, area_error, monitor, result);
    result[0] = as_c(found.whole);
    for (std::size_t i = 0; i < found.parts.size(); ++i) result[i + 1] = as_c(found.parts[i]);
  });
}

csgcast_status csgcast_count(const csgcast_model* model, csgcast_counts* result) {
  return guarded([&] {
    require(model != nullptr && result != nullptr, "the model or the place for the result is NULL");
    const ModelCounts counts = model->model.counts();
    *result = {counts.leaves, counts.surfaces, counts.parts, counts.cells, counts.bytes};
  });
}

csgcast_status csgcast_bounds(const csgcast_model* model, double lower[3], double upper[3]) {
  return guarded([&] {
    require(model != nullptr && lower != nullptr && upper != nullptr, "the model or the place for a corner is NULL");
    put(model->model.bounds().lower, lower);
    put(model->model.bounds().upper, upper);
  });
}

const char* csgcast_leaf_name(const csgcast_model* model, uint32_t leaf) {
  if (model == nullptr || leaf >= model->model.scene().leaves().size()) return nullptr;
  std::string name;
  if (guarded([&] { name = model->model.leaf_name(LeafId(leaf)); }) != CSGCAST_OK) return nullptr;
  last_leaf_name = std::move(name);
  return last_leaf_name.c_str();
}

csgcast_status csgcast_use_threads(int threads) {
  return guarded([&] {
    if (threads < 0)
      throw Error(ErrorCode::usage, {}, "a number of threads below 0", "", "give 1 or more, or 0 for one a core");
    threads_of_calls = threads;
  });
}

csgcast_status csgcast_cut(const csgcast_model* model, const double plane[4], const csgcast_section_options* options,
                           const csgcast_monitor* monitor, csgcast_section* result) {
  return guarded([&] {
    require(model != nullptr && plane != nullptr && result != nullptr,
            "the model, the plane or the place for the result is NULL");
    *result = {};
    SectionOptions job;
    job.relative_error = completed<csgcast_section_options>(options, CSGCAST_SECTION_OPTIONS).relative_error;
    job.progress = callback_of(monitor);
    auto memory = std::make_unique<SectionMemory>();
    memory->plane = {{plane[0], plane[1], plane[2]}, plane[3]};
    memory->section = model->model.section(memory->plane, job);
    list_arcs(*memory);
    const Section& section = memory->section;
    result->is_bounded = section.is_bounded ? 1 : 0;
    result->is_closed = section.is_closed ? 1 : 0;
    put(section.origin, result->origin);
    put(section.u, result->u_axis);
    put(section.v, result->v_axis);
    result->area = section.area.value;
    result->area_error = section.area.error;
    result->perimeter = section.perimeter.value;
    result->perimeter_error = section.perimeter.error;
    result->place_error = section.place_error;
    result->loops = section.loops.size();
    result->offsets = memory->offsets.data();
    result->arcs = memory->arcs.data();
    result->memory = memory.release();
  });
}

void csgcast_free_section(csgcast_section* section) {
  if (section == nullptr) return;
  delete static_cast<SectionMemory*>(section->memory);
  *section = {};
}

csgcast_status csgcast_section_svg(const csgcast_section* section, double tolerance, const char** text) {
  return guarded([&] {
    SectionMemory& memory = memory_of(section);
    require(text != nullptr, "the place for the text is NULL");
    memory.text = section_svg(memory.section, tolerance != 0 ? tolerance : unseen_tolerance(memory.section));
    *text = memory.text.c_str();
  });
}

csgcast_status csgcast_section_json(const csgcast_section* section, const char** text) {
  return guarded([&] {
    SectionMemory& memory = memory_of(section);
    require(text != nullptr, "the place for the text is NULL");
    memory.text = section_json(memory.section);
    *text = memory.text.c_str();
  });
}

csgcast_status csgcast_section_polylines(const csgcast_section* section, double tolerance, csgcast_polylines* result) {
  return guarded([&] {
    SectionMemory& memory = memory_of(section);
    require(result != nullptr, "the place for the result is NULL");
    const auto lines = section_polylines(memory.section, tolerance);
    memory.line_offsets = {0};
    memory.line_points.clear();
    for (const std::vector<PlanePoint>& line : lines) {
      for (const PlanePoint p : line) memory.line_points.insert(memory.line_points.end(), {p.u, p.v});
      memory.line_offsets.push_back(memory.line_points.size() / 2);
    }
    *result = {lines.size(), memory.line_offsets.data(), memory.line_points.data()};
  });
}

csgcast_status csgcast_write_section(const csgcast_model* model, const csgcast_section* section, const char* path,
                                     int pixels) {
  return guarded([&] {
    const SectionMemory& memory = memory_of(section);
    require(model != nullptr && path != nullptr, "the model or the path is NULL");
    write_section(model->model.scene(), memory.plane, memory.section, path, pixels);
  });
}

csgcast_status csgcast_thinnest(const csgcast_model* model, size_t grid, const csgcast_monitor* monitor,
                                csgcast_thin_place* result) {
  return guarded([&] {
    require(model != nullptr && result != nullptr, "the model or the place for the result is NULL");
    *result = {};
    result->leaf = CSGCAST_NONE;
    const std::optional<ThinPlace> found = model->model.thinnest(grid, callback_of(monitor));
    if (!found) return;
    result->is_found = 1;
    result->thickness = found->thickness;
    put(found->place, result->place);
    put(found->normal, result->normal);
    result->leaf = found->leaf.index();
  });
}

csgcast_status csgcast_check(const csgcast_model* model, const csgcast_monitor* monitor, csgcast_report* result) {
  return guarded([&] {
    require(model != nullptr && result != nullptr, "the model or the place for the result is NULL");
    *result = {};
    CheckOptions options;
    options.progress = callback_of(monitor);
    const CheckReport report = model->model.check(options);
    auto memory = listed(model->model.scene(), report);
    result->is_empty = report.is_empty ? 1 : 0;
    result->is_unbounded = report.is_unbounded ? 1 : 0;
    const auto list = [](const auto& of, size_t& count, auto& first) {
      count = of.size();
      first = of.data();
    };
    list(memory->overlaps, result->overlap_count, result->overlaps);
    list(memory->contacts, result->contact_count, result->contacts);
    list(memory->unbounded, result->unbounded_count, result->unbounded_parts);
    list(memory->empty, result->empty_count, result->empty_parts);
    list(memory->redundancies, result->redundancy_count, result->redundancies);
    result->not_asked = report.not_asked;
    result->memory = memory.release();
  });
}

void csgcast_free_report(csgcast_report* report) {
  if (report == nullptr) return;
  delete static_cast<ReportMemory*>(report->memory);
  *report = {};
}

size_t csgcast_channels(csgcast_mode mode) {
  return is_mode(mode) ? static_cast<size_t>(channels(content(static_cast<Mode>(mode)))) : 0;
}

csgcast_status csgcast_render(const csgcast_model* model, const csgcast_render_options* options,
                              const csgcast_monitor* monitor, float* values, size_t count) {
  return guarded([&] {
    require(model != nullptr && values != nullptr, "the model or the place for the picture is NULL");
    const auto job = completed<csgcast_render_options>(options, CSGCAST_RENDER_OPTIONS);
    const size_t pixels = static_cast<size_t>(std::max(job.width, 0)) * static_cast<size_t>(std::max(job.height, 0));
    if (count != pixels * csgcast_channels(job.mode)) {
      throw Error(ErrorCode::usage, {}, "there is room for " + std::to_string(count) + " numbers",
                  "the picture has " + std::to_string(pixels * csgcast_channels(job.mode)),
                  "give room for width x height x csgcast_channels()");
    }
    const Film film = picture(model, job, monitor);
    std::copy(film.values().begin(), film.values().end(), values);
  });
}

csgcast_status csgcast_render_file(const csgcast_model* model, const csgcast_render_options* options,
                                   const csgcast_monitor* monitor, const char* path) {
  return guarded([&] {
    require(model != nullptr && path != nullptr, "the model or the path is NULL");
    check_image_path(path);
    write_image(picture(model, completed<csgcast_render_options>(options, CSGCAST_RENDER_OPTIONS), monitor), path);
  });
}

}  // extern "C"
