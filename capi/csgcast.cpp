// SPDX-License-Identifier: MIT
#include "capi/csgcast.h"

#include <algorithm>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include "csg/error.h"
#include "csg/text/builder.h"
#include "csg/text/reader.h"
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
  } catch (const Error& error) {
    last_error = error.what();
    return CSGCAST_BAD_INPUT;
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

csgcast_model* made_of(text::Document document) {
  SceneDescription description = text::build(std::move(document));
  return std::make_unique<csgcast_model>(csgcast_model{Model(std::move(description.solid))}).release();
}

}  // namespace

extern "C" {

const char* csgcast_last_error(void) { return last_error.c_str(); }

const char* csgcast_version(void) { return CSGCAST_VERSION; }

csgcast_status csgcast_load(const char* path, csgcast_model** model) {
  return guarded([&] {
    if (model != nullptr) *model = nullptr;
    require(path != nullptr && model != nullptr, "the path or the place for the model is NULL");
    *model = made_of(text::read_file(path));
  });
}

csgcast_status csgcast_read(const char* text, size_t length, const char* name, csgcast_model** model) {
  return guarded([&] {
    if (model != nullptr) *model = nullptr;
    require(text != nullptr && name != nullptr && model != nullptr,
            "the text, its name or the place for the model is NULL");
    *model = made_of(text::read({text, length}, name));
  });
}

void csgcast_free(csgcast_model* model) { delete model; }

csgcast_status csgcast_cast(const csgcast_model* model, size_t rays, const double* origins, const double* directions,
                            double t_min, double t_max, csgcast_intervals* result) {
  return guarded([&] {
    require(model != nullptr && result != nullptr, "the model or the place for the result is NULL");
    *result = {};
    require(rays == 0 || (origins != nullptr && directions != nullptr), "the origins or the directions are NULL");
    QueryOptions options;
    options.span = {t_min, t_max};
    options.faces = options.normals = true;
    auto table =
        std::make_unique<IntervalTable>(model->model.intervals({{origins, 3 * rays}, {directions, 3 * rays}}, options));
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

csgcast_status csgcast_locate(const csgcast_model* model, size_t points, const double* coordinates, int8_t* result) {
  return guarded([&] {
    require(model != nullptr, "the model is NULL");
    require(points == 0 || (coordinates != nullptr && result != nullptr),
            "the points or the place for the result is NULL");
    const std::vector<Location> found = model->model.locate({coordinates, 3 * points});
    std::transform(found.begin(), found.end(), result, sign_of);
  });
}

csgcast_status csgcast_measure(const csgcast_model* model, double relative_error, double area_error,
                               csgcast_measures* result) {
  return guarded([&] {
    require(model != nullptr && result != nullptr, "the model or the place for the result is NULL");
    MeasureOptions options;
    options.relative_error = relative_error;
    options.relative_area_error = area_error;
    const Measures m = measure(model->model.scene(), options).whole;
    *result = {};
    result->is_bounded = m.is_bounded ? 1 : 0;
    result->is_as_asked = m.is_as_asked ? 1 : 0;
    result->volume = m.volume.value;
    result->volume_error = m.volume.error;
    result->area = m.area.value;
    result->area_error = m.area.error;
    result->mass = m.mass.value;
    result->mass_error = m.mass.error;
    for (std::size_t i = 0; i < 3; ++i) {
      result->centroid[i] = m.centroid[i];
      result->lower[i] = m.bounds.lower[i];
      result->upper[i] = m.bounds.upper[i];
    }
    for (std::size_t i = 0; i < 6; ++i) result->inertia[i] = m.inertia[i];
    result->centroid_error = m.centroid_error;
    result->inertia_error = m.inertia_error;
    result->bounds_error = m.bounds_error;
  });
}

}  // extern "C"
