// SPDX-License-Identifier: MIT
#include "bindings/c/csgcast.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "csg/base/error.h"
#include "csg/solid/parts.h"
#include "csg/text/statement/builder.h"
#include "csg/text/syntax/reader.h"
#include "measure/measure.h"
#include "query/model.h"

struct csgcast_model {
  csgcast::Model model;
};

namespace {

using namespace csgcast;

thread_local std::string last_error;

/// No exception leaves a C function.
template <class Call>
csgcast_status guarded(Call&& call) {
  last_error.clear();
  try {
    call();
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

constexpr csgcast_options defaults{CSGCAST_FACETS_AUTO, -1, nullptr, 0};

text::Facets facets_of(csgcast_facets facets) {
  switch (facets) {
    case CSGCAST_FACETS_AUTO:
      return text::Facets::automatic;
    case CSGCAST_FACETS_ALWAYS:
      return text::Facets::always;
    case CSGCAST_FACETS_NEVER:
      return text::Facets::never;
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

csgcast_model* made_of(text::Document document, const csgcast_options& options) {
  const Welding welding = options.weld == -1  ? Welding::derived()
                          : options.weld == 0 ? Welding{}
                                              : Welding::by_hand(options.weld);
  SceneDescription description = text::build(std::move(document), {facets_of(options.facets)});
  Solid solid = selected(std::move(description.solid), options);
  return std::make_unique<csgcast_model>(csgcast_model{Model(std::move(solid), welding)}).release();
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
  return measure(model->model.scene(), options);
}

const Part* part_of(const csgcast_model* model, size_t part) {
  return model != nullptr && part < model->model.scene().parts().size() ? &model->model.scene().parts()[part] : nullptr;
}

}  // namespace

extern "C" {

const char* csgcast_last_error(void) { return last_error.c_str(); }

const char* csgcast_version(void) { return CSGCAST_VERSION; }

csgcast_status csgcast_load(const char* path, csgcast_model** model) {
  return csgcast_load_with(path, &defaults, model);
}

csgcast_status csgcast_load_with(const char* path, const csgcast_options* options, csgcast_model** model) {
  return guarded([&] {
    if (model != nullptr) *model = nullptr;
    require(path != nullptr && options != nullptr && model != nullptr,
            "the path, the options or the place for the model is NULL");
    *model = made_of(text::read_file(path), *options);
  });
}

csgcast_status csgcast_read(const char* text, size_t length, const char* name, csgcast_model** model) {
  return csgcast_read_with(text, length, name, &defaults, model);
}

csgcast_status csgcast_read_with(const char* text, size_t length, const char* name, const csgcast_options* options,
                                 csgcast_model** model) {
  return guarded([&] {
    if (model != nullptr) *model = nullptr;
    require(text != nullptr && name != nullptr && options != nullptr && model != nullptr,
            "the text, its name, the options or the place for the model is NULL");
    *model = made_of(text::read({text, length}, name), *options);
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

}  // extern "C"
