#ifndef COIF_VERSION_H
#define COIF_VERSION_H
/* The version of these headers, for C and C++. The libraries that a program was linked with say theirs by
 * coif_version(). CMakeLists.txt reads the three numbers from here. */

#define COIF_VERSION_MAJOR 0
#define COIF_VERSION_MINOR 1
#define COIF_VERSION_PATCH 0

/* Grows with every version: 1002003 is 1.2.3. */
#define COIF_VERSION_NUMBER (COIF_VERSION_MAJOR * 1000000 + COIF_VERSION_MINOR * 1000 + COIF_VERSION_PATCH)

#define COIF_VERSION_JOINED_(major, minor, patch) #major "." #minor "." #patch
#define COIF_VERSION_TEXT_(major, minor, patch) COIF_VERSION_JOINED_(major, minor, patch)
/* "0.1.0" */
#define COIF_VERSION COIF_VERSION_TEXT_(COIF_VERSION_MAJOR, COIF_VERSION_MINOR, COIF_VERSION_PATCH)

#endif
