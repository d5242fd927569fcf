/* SPDX-License-Identifier: MIT */
#ifndef CSGCAST_CAPI_CSGCAST_H
#define CSGCAST_CAPI_CSGCAST_H

/* csgcast for C and for languages that call it: a model of a scene text, and questions to it.
 *
 * Functions return CSGCAST_OK or an error; then csgcast_last_error() of the same thread says what was wrong, why, and
 * what to do. Numbers of points, origins and directions are 3 x count. A model may be asked by any number of threads at
 * once; a call works on all cores, unless csgcast_use_threads() says otherwise. Lengths are in the scene's unit.
 *
 * Structs of options begin with their size, and may grow: begin with the macro of the same name, as in
 *   csgcast_render_options options = CSGCAST_RENDER_OPTIONS;
 * Wherever options are taken NULL stands for what the macro says. What a later version adds is zero for programs that
 * do not know it, and means what it was before. */

#include <limits.h>
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
  CSGCAST_FACETS_NEVER = 2,
  CSGCAST_FACETS_INT = INT_MAX /* none of them: with it, C++ takes any int for one of this type */
} csgcast_facets;

typedef struct csgcast_options {
  size_t size; /* sizeof(csgcast_options) */
  csgcast_facets facets;
  double weld;              /* faces at most this share of the scene's size apart become one, at most 1/128; 0: none do;
                               -1: those that only the rounding of their own numbers keeps apart */
  const char* const* parts; /* the names of those that are all there is; NULL: the whole scene; none of them: nothing */
  size_t part_count;
  int skip_unsupported; /* 1: statements of OpenSCAD that are not supported yet are left out; 0: they are an error */
} csgcast_options;
#define CSGCAST_OPTIONS \
  { sizeof(csgcast_options), CSGCAST_FACETS_AUTO, -1, NULL, 0, 0 }
csgcast_status csgcast_load_with(const char* path, const csgcast_options* options, csgcast_model** model);
csgcast_status csgcast_read_with(const char* text, size_t length, const char* name, const csgcast_options* options,
                                 csgcast_model** model);
/* NULL is nothing to free. */
void csgcast_free(csgcast_model* model);

/* The named parts, in file order. A name is valid as long as the model; NULL, and density NaN, beyond the last. */
size_t csgcast_part_count(const csgcast_model* model);
const char* csgcast_part_name(const csgcast_model* model, size_t part);
double csgcast_part_density(const csgcast_model* model, size_t part);

/* How large a model is. */
typedef struct csgcast_counts {
  size_t leaves;
  size_t surfaces;
  size_t parts;
  size_t cells; /* that some surface crosses */
  size_t bytes; /* memory of the cells */
} csgcast_counts;
csgcast_status csgcast_count(const csgcast_model* model, csgcast_counts* result);
/* A box that holds the solid, quickly found and maybe wide; infinite where it may be unbounded. lower > upper if the
 * solid is empty. */
csgcast_status csgcast_bounds(const csgcast_model* model, double lower[3], double upper[3]);
/* The kind of a leaf, and which statement made it: "sphere at part.csg:3:5". NULL beyond the last. Valid until this
 * thread's next call of it. */
const char* csgcast_leaf_name(const csgcast_model* model, uint32_t leaf);

/* From now on the calls of this thread share their work among so many threads, at most 1024; 0: one a core, which is
 * what holds at first. Results do not depend on it. */
csgcast_status csgcast_use_threads(int threads);

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

/* How thick the solid is at the first face that each ray enters by, from t = 0 on: the way from there straight in,
 * against the normal, to the boundary again. 0 where a ray enters by none, INFINITY where nothing ends the solid. */
csgcast_status csgcast_thickness(const csgcast_model* model, size_t rays, const double* origins,
                                 const double* directions, const csgcast_monitor* monitor, double* result);

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

/* An arc of a section: conic[0] u^2 + conic[1] uv + conic[2] v^2 + conic[3] u + conic[4] v + conic[5] = 0; a straight
 * line if the first three are 0. Places are u, v; middle is somewhere between. The inside is on its left. */
typedef struct csgcast_arc {
  double conic[6];
  double from[2], middle[2], to[2];
  uint32_t surface;
} csgcast_arc;

/* What the plane plane[0] x + plane[1] y + plane[2] z = plane[3] cuts out; in the plane of a face what is just beyond
 * it. The place u, v is origin + u * u_axis + v * v_axis in space. The arcs of loop i are [offsets[i], offsets[i + 1]).
 */
typedef struct csgcast_section {
  int is_bounded; /* 0: the solid may be unbounded, and nothing is told */
  int is_closed;  /* 0: some arcs have no neighbour, as the curves come too close to tell */
  double origin[3], u_axis[3], v_axis[3];
  double area, area_error;
  double perimeter, perimeter_error;
  double place_error; /* the ends of arcs are nearer than this to where they should be */
  size_t loops;
  const size_t* offsets; /* loops + 1 */
  const csgcast_arc* arcs;
  void* memory; /* csgcast's own */
} csgcast_section;
typedef struct csgcast_section_options {
  size_t size;           /* sizeof(csgcast_section_options) */
  double relative_error; /* of area and perimeter */
} csgcast_section_options;
#define CSGCAST_SECTION_OPTIONS \
  { sizeof(csgcast_section_options), 1e-6 }
csgcast_status csgcast_cut(const csgcast_model* model, const double plane[4], const csgcast_section_options* options,
                           const csgcast_monitor* monitor, csgcast_section* result);
void csgcast_free_section(csgcast_section* section);
/* A section as an SVG picture within `tolerance` of its curves (0: less than anybody sees), and as a JSON object. *text
 * is valid until the next such call for this section, which is one thread's at a time. */
csgcast_status csgcast_section_svg(const csgcast_section* section, double tolerance, const char** text);
csgcast_status csgcast_section_json(const csgcast_section* section, const char** text);
/* The loops as polylines: no arc is farther than `tolerance` from its chords. The points u, v of loop i are
 * [offsets[i], offsets[i + 1]), the last one the first again. Valid until the next such call for this section. */
typedef struct csgcast_polylines {
  size_t loops;
  const size_t* offsets; /* loops + 1 */
  const double* points;  /* 2 x offsets[loops] */
} csgcast_polylines;
csgcast_status csgcast_section_polylines(const csgcast_section* section, double tolerance, csgcast_polylines* result);
/* Writes a section of this model as .svg, .json or .png, whose longer side has `pixels`, 1 to 16384. */
csgcast_status csgcast_write_section(const csgcast_model* model, const csgcast_section* section, const char* path,
                                     int pixels);

/* A place on the boundary, and how far it is from there straight in, against the normal, to the boundary again. */
typedef struct csgcast_thin_place {
  int is_found; /* 0: the solid is empty, or may be unbounded */
  double thickness;
  double place[3];
  double normal[3]; /* unit, out of the solid */
  uint32_t leaf;    /* whose face it is */
} csgcast_thin_place;
/* The thinnest wall that grid x grid rays along each axis meet, 1 to 16384. No bound. */
csgcast_status csgcast_thinnest(const csgcast_model* model, size_t grid, const csgcast_monitor* monitor,
                                csgcast_thin_place* result);

/* Two parts that share space: proved. `place` is in both. */
typedef struct csgcast_overlap {
  uint32_t first, second; /* parts */
  double volume, volume_error;
  double place[3];
} csgcast_overlap;
/* Two parts that may share `most`, or nothing. */
typedef struct csgcast_contact {
  uint32_t first, second;
  double most;
} csgcast_contact;
/* A leaf or Boolean operator without which the shape would be the same: proved. */
typedef struct csgcast_redundancy {
  const char* name; /* "sphere at part.csg:3:5" */
  const char* why;
  uint32_t first_leaf, leaf_end; /* of those in it */
} csgcast_redundancy;
/* What may be wrong with a solid. */
typedef struct csgcast_report {
  int is_empty;
  int is_unbounded; /* it may be */
  size_t overlap_count, contact_count, unbounded_count, empty_count, redundancy_count;
  const csgcast_overlap* overlaps;
  const csgcast_contact* contacts;
  const uint32_t* unbounded_parts;
  const uint32_t* empty_parts;
  const csgcast_redundancy* redundancies;
  size_t not_asked; /* statements that were not asked, as they are among hundreds of others */
  void* memory;     /* csgcast's own */
} csgcast_report;
csgcast_status csgcast_check(const csgcast_model* model, const csgcast_monitor* monitor, csgcast_report* result);
void csgcast_free_report(csgcast_report* report);

/* What a picture shows. */
typedef enum csgcast_mode {
  CSGCAST_SHADED = 0,        /* light: 3 linear numbers a pixel */
  CSGCAST_EDGES = 1,         /* a line drawing: 3 */
  CSGCAST_XRAY = 2,          /* how long each ray is inside: 1 */
  CSGCAST_DEPTH = 3,         /* how far the first boundary is from the eye, INFINITY if there is none: 1 */
  CSGCAST_NORMAL = 4,        /* which way the first boundary faces: 3 */
  CSGCAST_ID = 5,            /* which leaf it belongs to: 1 */
  CSGCAST_MODE_INT = INT_MAX /* no mode: with it, C++ takes any int for one of this type */
} csgcast_mode;
/* How many numbers a pixel has in that mode; 0 if there is no such mode. */
size_t csgcast_channels(csgcast_mode mode);

typedef struct csgcast_camera {
  double eye[3], look_at[3], up[3];
  double fov;    /* vertical, in degrees; of a perspective camera */
  double height; /* what a parallel camera shows; 0: perspective */
} csgcast_camera;
typedef struct csgcast_light {
  int is_directional; /* 0: `place` is where it is; else where its light goes */
  double place[3];
  double color[3]; /* linear */
  double intensity;
  double falloff; /* of one with a place: inverse-square, `intensity` is reached at this distance; 0: the same
                     everywhere */
} csgcast_light;
typedef struct csgcast_render_options {
  size_t size; /* sizeof(csgcast_render_options) */
  int width, height;
  int samples; /* rays a pixel, rounded up to a square number */
  csgcast_mode mode;
  int is_adaptive;              /* all samples only in pixels that do not look like those around */
  const csgcast_camera* camera; /* NULL: the scene's, or one that frames the solid */
  const csgcast_light* lights;  /* NULL: the scene's, or one beside the camera */
  size_t light_count;
  const double* background; /* 3 linear numbers; NULL: the scene's, or a pale blue */
} csgcast_render_options;
#define CSGCAST_RENDER_OPTIONS \
  { sizeof(csgcast_render_options), 800, 600, 1, CSGCAST_SHADED, 0, NULL, NULL, 0, NULL }
/* A picture: rows from the top, width x height x csgcast_channels() numbers, which `count` has to be. */
csgcast_status csgcast_render(const csgcast_model* model, const csgcast_render_options* options,
                              const csgcast_monitor* monitor, float* values, size_t count);
/* The same as a file: .png, .jpg, .tif or .exr. It appears whole or not at all. */
csgcast_status csgcast_render_file(const csgcast_model* model, const csgcast_render_options* options,
                                   const csgcast_monitor* monitor, const char* path);

#ifdef __cplusplus
}
#endif

#endif
