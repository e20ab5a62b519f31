/* Volumes, and what a shape adds to the picture. All of it is there since 1.1.
 *
 * A shape speaks of its own object space; where it stands in the world the host knows. Matrices are 16
 * numbers, column by column, and take column vectors. Colours are linear Rec.709. */
#ifndef PLINIAN_SDK_ABI_SCENE_H
#define PLINIAN_SDK_ABI_SCENE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A sparse volume of densities, perhaps with temperatures: what attributes of the data type "plinian.volume"
 * hand on. It is the host's, and good until the function returns that read or made it. */
#define PLINIAN_VOLUME_TYPE "plinian.volume"
typedef struct PlinianVolume PlinianVolume;

typedef struct PlinianVolumeInfo {
  size_t size;
  int32_t first[3], count[3];   /* box of the voxels that hold any density */
  double object_from_index[16]; /* voxel centres are at whole indices */
  float density_max;            /* [unit of the source] */
  float temperature_max;        /* [K]; 0: cold throughout */
  int64_t voxels;               /* with any density */
} PlinianVolumeInfo;

/* A volume to be made, block by block, so that empty space costs nothing. */
typedef struct PlinianVolumeSource {
  size_t size;
  int32_t first[3], count[3]; /* box of voxels; outside it there is nothing */
  double object_from_index[16];
  uint32_t flags;
  uint64_t content; /* equal for equal content; 0: not known */
  void* user;
  /* Fills the block of 8^3 voxels, x fastest, that begins at `first` (multiples of 8, so that it may stick
   * out of the box): density >= 0, and temperature [K], which is null where the volume has none. Both are
   * zero beforehand. Returns 1; 0 for an empty block, which it need not fill; -1 to give up. */
  int (*fill)(void* user, const int32_t first[3], float* density, float* temperature);
} PlinianVolumeSource;

#define PLINIAN_VOLUME_TEMPERATURE 1u /* it has temperatures */
#define PLINIAN_VOLUME_CONCURRENT 2u  /* fill may run on several threads at a time */

/* A participating medium: density * density_scale * (sigma_s + sigma_a) is its extinction. */
typedef struct PlinianMedium {
  size_t size;
  const char* name;            /* behind the node's own; may be null */
  uint32_t shape;              /* 0 voxels, 1 box [-1, 1]^3, 2 sphere of radius 1; the latter of density 1 */
  const PlinianVolume* volume; /* of voxels */
  double object_from_medium[16]; /* beside the volume's own */
  float density_scale;           /* [1 / unit of the source] >= 0 */
  float sigma_s[3], sigma_a[3];  /* [1/m] >= 0, scattering and absorption; scaling a shape keeps them */
  uint32_t phase;                /* 0 isotropic, 1 Henyey-Greenstein, 2 Schlick, 3 two lobes */
  float g, g_back;               /* [-] in (-1, 1): mean cosine; of the second lobe */
  float blend;                   /* [-] in [0, 1]: share of the second lobe */
  float emission_scale;          /* [radiance per m at 1800 K] >= 0; 0: none */
  float emission_exposure;       /* [stops] */
  float temperature_scale;       /* [K per stored kelvin] */
  float temperature_offset;      /* [K] */
} PlinianMedium;

/* Attributes of the data type "medium" hand on how a medium looks: a PlinianMedium of which shape,
 * volume, name and matrix mean nothing. */
#define PLINIAN_MEDIUM_TYPE "medium"

typedef struct PlinianLight {
  size_t size;
  const char* name;  /* behind the node's own; may be null */
  uint32_t type;     /* 0 directional, 1 spot, 2 point, 3 ambient */
  float toward[3];   /* to the light, any length but 0; a spot shines along its negative */
  float position[3]; /* spot and point */
  float colour[3];   /* >= 0 */
  float intensity; /* >= 0: irradiance facing the light, at distance 1 of spot and point; ambient: radiance */
  float exposure;  /* [stops] */
  uint32_t falloff; /* spot and point: 0 inverse square, 1 linear, 2 none */
  float radius;     /* [object units] >= 0: falloff holds still nearer than this */
  float cone_angle; /* [degrees] full angle of a spot's cone, in (0, 180) */
  float penumbra;   /* [degrees] soft edge inside the cone, per side, >= 0 */
} PlinianLight;

typedef struct PlinianCamera {
  size_t size;
  const char* name;              /* behind the node's own; may be null */
  double object_from_camera[16]; /* rigid; looks along -z, +y up */
  float focal_length;            /* [mm] > 0 */
  float film_back[2];            /* [mm] > 0, horizontal, vertical */
  uint32_t fit;                  /* 0 fill, 1 horizontal, 2 vertical, 3 overscan */
  float film_offset[2];          /* [mm] */
  float pixel_aspect;            /* [-] > 0 */
  float near_clip;               /* [object units] >= 0 */
} PlinianCamera;

/* Takes what a shape contributes. A failure is remembered by the compute table. */
typedef struct PlinianContribution PlinianContribution;
typedef struct PlinianContribute {
  size_t size;
  int (*add_medium)(PlinianContribution*, const PlinianMedium*);
  int (*add_light)(PlinianContribution*, const PlinianLight*);
  int (*add_camera)(PlinianContribution*, const PlinianCamera*);
  /* Of what only a viewport shows: the bounds of media are known. */
  int (*add_bounds)(PlinianContribution*, const double minimum[3], const double maximum[3]);
} PlinianContribute;

#ifdef __cplusplus
}
#endif
#endif
