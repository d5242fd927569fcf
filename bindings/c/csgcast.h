/* SPDX-License-Identifier: MIT */
#ifndef CSGCAST_CAPI_CSGCAST_H
#define CSGCAST_CAPI_CSGCAST_H

/* csgcast for C and for languages that call it: a model of a scene text, and questions to it.
 *
 * Functions return CSGCAST_OK or an error; then csgcast_last_error() of the same thread says what was wrong, why, and
 * what to do. Numbers of points, origins and directions are 3 x count. A model may be asked by any number of threads at
 * once; a call works on all cores. Lengths are in the scene's unit. */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum csgcast_status {
  CSGCAST_OK = 0,
  CSGCAST_FAILED = 1,    /* the machine: no memory */
  CSGCAST_BAD_INPUT = 2, /* what was given */
  CSGCAST_CANCELLED = 3  /* a monitor's progress() returned 0: there is no result */
} csgcast_status;

/* No surface, leaf or part. */
#define CSGCAST_NONE UINT32_MAX

typedef struct csgcast_model csgcast_model;

/* The sentence that tells of the last error in this thread; "" if there was none. Valid until the thread's next call.
 */
const char* csgcast_last_error(void);
/* "0.1.0" */
const char* csgcast_version(void);

/* Reads a scene text from a file, or from memory (`name` stands for the file in messages), and makes it ready. *model
 * is NULL on failure. */
csgcast_status csgcast_load(const char* path, csgcast_model** model);
csgcast_status csgcast_read(const char* text, size_t length, const char* name, csgcast_model** model);

/* Which curved solids become polyhedra with OpenSCAD's vertices. */
typedef enum csgcast_facets {
  CSGCAST_FACETS_AUTO = 0, /* those with an explicit 0 < $fn <= 16 */
  CSGCAST_FACETS_ALWAYS = 1,
  CSGCAST_FACETS_NEVER = 2
} csgcast_facets;

/* What the functions above take as {CSGCAST_FACETS_AUTO, -1, NULL, 0}. */
typedef struct csgcast_options {
  csgcast_facets facets;
  double weld;              /* faces at most this share of the scene's size apart become one, at most 1/128; 0: none do;
                               -1: those that only the rounding of their own numbers keeps apart */
  const char* const* parts; /* the names of those that are all there is; NULL: the whole scene; none of them: nothing */
  size_t part_count;
} csgcast_options;
csgcast_status csgcast_load_with(const char* path, const csgcast_options* options, csgcast_model** model);
csgcast_status csgcast_read_with(const char* text, size_t length, const char* name, const csgcast_options* options,
                                 csgcast_model** model);
/* NULL is nothing to free. */
void csgcast_free(csgcast_model* model);

/* The named parts, in file order. A name is valid as long as the model; NULL, and density NaN, beyond the last. */
size_t csgcast_part_count(const csgcast_model* model);
const char* csgcast_part_name(const csgcast_model* model, size_t part);
double csgcast_part_density(const csgcast_model* model, size_t part);

/* How far a call is. */
typedef struct csgcast_progress {
  double share;          /* of the work that is done, in [0, 1]; it never falls within a call, and is 1 at the end */
  double relative_error; /* of csgcast_measure(): a volume's error at present, as a share of the volume; else NaN */
} csgcast_progress;

/* Whom a call tells how far it is: progress(.., data) is called now and then, by any thread, but never by two at once.
 * If it returns 0 the call ends with CSGCAST_CANCELLED; else it goes on. It must not throw or jump out. Wherever a
 * monitor is taken NULL is allowed, as is a monitor without progress: nobody is told. */
typedef struct csgcast_monitor {
  int (*progress)(const csgcast_progress* progress, void* data);
  void* data;
} csgcast_monitor;

/* The intervals of many rays: those of ray i are [offsets[i], offsets[i + 1]). Ends come in pairs, entry and exit: of
 * interval k ends 2 k and 2 k + 1. t is the double nearest to the exact one; infinite, or where the span cut the ray
 * off, with CSGCAST_NONE. Normals are unit and point out of the solid. */
typedef struct csgcast_intervals {
  size_t rays;
  size_t count;             /* of intervals */
  const uint64_t* offsets;  /* rays + 1 */
  const double* t;          /* 2 x count */
  const uint32_t* surfaces; /* 2 x count */
  const uint32_t* leaves;   /* 2 x count */
  const uint32_t* parts;    /* 2 x count: index into the parts, in file order */
  const double* normals;    /* 6 x count */
  void* memory;             /* csgcast's own */
} csgcast_intervals;

/* In [t_min, t_max]; 0 and INFINITY for rays, -INFINITY and INFINITY for lines. */
csgcast_status csgcast_cast(const csgcast_model* model, size_t rays, const double* origins, const double* directions,
                            double t_min, double t_max, const csgcast_monitor* monitor, csgcast_intervals* result);
void csgcast_free_intervals(csgcast_intervals* result);

/* Where rays first cross the boundary in [t_min, t_max], entering or leaving: `rays` numbers each; INFINITY,
 * CSGCAST_NONE and 0 without a hit. surfaces and is_entry may be NULL. */
csgcast_status csgcast_first_hits(const csgcast_model* model, size_t rays, const double* origins,
                                  const double* directions, double t_min, double t_max, const csgcast_monitor* monitor,
                                  double* t, uint32_t* surfaces, uint8_t* is_entry);
/* 1 where a ray meets the inside of the solid between t_min and t_max, else 0. */
csgcast_status csgcast_any_hits(const csgcast_model* model, size_t rays, const double* origins,
                                const double* directions, double t_min, double t_max, const csgcast_monitor* monitor,
                                uint8_t* result);

/* 1 inside, 0 on the boundary, -1 outside: never falsely inside or outside. */
csgcast_status csgcast_locate(const csgcast_model* model, size_t points, const double* coordinates,
                              const csgcast_monitor* monitor, int8_t* result);

/* True values are within the errors. Of a solid that may be unbounded numbers are infinite or none. */
typedef struct csgcast_measures {
  int is_bounded;
  int is_as_asked; /* errors are as small as asked for */
  double volume, volume_error;
  double area, area_error;
  double mass, mass_error;
  double centroid[3], centroid_error; /* the centre of mass; of each coordinate */
  double inertia[6], inertia_error;   /* xx, yy, zz, xy, xz, yz about the centroid; of each */
  double lower[3], upper[3], bounds_error;
  double principal_moments[3], principal_error; /* of the inertia, ascending; of each */
  double principal_axes[9];                     /* three for each moment: unit, right-handed */
  double principal_angles[3]; /* of each axis: radians to the true one; INFINITY: undetermined, moments are too close */
} csgcast_measures;

/* Of the whole solid; relative errors of volume and area, such as 1e-6 and 1e-3. */
csgcast_status csgcast_measure(const csgcast_model* model, double relative_error, double area_error,
                               const csgcast_monitor* monitor, csgcast_measures* result);
/* The same of the whole solid and of each part: result has room for 1 + csgcast_part_count(model). */
csgcast_status csgcast_measure_parts(const csgcast_model* model, double relative_error, double area_error,
                                     const csgcast_monitor* monitor, csgcast_measures* result);

#ifdef __cplusplus
}
#endif

#endif
