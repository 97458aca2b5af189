/* SPDX-License-Identifier: MIT */
/* packages.c - finds the mesh files of a URDF. */
#include "robot/packages.h"
#include "util/error.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { PATH_MOST = 4096 };

static bool is_file(const char *path) {
  struct stat s;
  return stat(path, &s) == 0 && !S_ISDIR(s.st_mode);
}

static bool is_folder(const char *path) {
  struct stat s;
  return stat(path, &s) == 0 && S_ISDIR(s.st_mode);
}

static char *copy_of(const char *text) {
  size_t size = strlen(text) + 1;
  char *copy = sepax_allocate(size);
  return copy != NULL ? memcpy(copy, text, size) : NULL;
}

/* Make the path FOLDER/FILE. True if the file exists. */
static bool is_in(char *path, int folder_length, const char *folder, const char *file) {
  int used = snprintf(path, PATH_MOST, "%.*s/%s", folder_length, folder, file);
  return used > 0 && used < PATH_MOST && is_file(path);
}

/* The absolute path; its .. and links are kept. */
static bool make_absolute(const char *path, char whole[PATH_MOST]) {
  char here[PATH_MOST] = "";
  if (path[0] != '/' && getcwd(here, sizeof here) == NULL) {
    return false;
  }
  return snprintf(whole, PATH_MOST, "%s%s%s", here, path[0] != '/' ? "/" : "", path) < PATH_MOST;
}

/* Search NAME/rest beside the URDF and beside each folder above it, or `rest` in a folder called
 * NAME. `folder` receives the first folder of this name, or stays empty. */
static bool search_package(char *path, const char *urdf, const char *name_and_path,
                           char folder[PATH_MOST]) {
  char whole[PATH_MOST];
  char beside[PATH_MOST];
  if (!make_absolute(urdf, whole)) {
    return false;
  }
  size_t name = strcspn(name_and_path, "/");
  const char *rest = name_and_path + name + (name_and_path[name] == '/');
  bool found = false;
  for (char *end = strrchr(whole, '/'); end != NULL && !found; end = strrchr(whole, '/')) {
    *end = '\0';
    const char *last = strrchr(whole, '/');
    last = last != NULL ? last + 1 : whole;
    bool is_package = strlen(last) == name && strncmp(last, name_and_path, name) == 0;
    int length = (int)strlen(whole);
    found = is_in(path, length, whole, name_and_path) ||
            (is_package && is_in(path, length, whole, rest));
    if (folder[0] == '\0' && (is_package || (snprintf(beside, PATH_MOST, "%s/%.*s", whole,
                                                      (int)name, name_and_path) < PATH_MOST &&
                                             is_folder(beside)))) {
      strcpy(folder, is_package ? whole : beside);
    }
  }
  return found;
}

static bool find_in_package(const mesh_places *p, const char *name_and_path, char *path,
                            sepax_error *error) {
  size_t name = strcspn(name_and_path, "/");
  for (size_t n = 0; n < p->packages; n++) {
    const sepax_package *package = &p->package[n];
    if (strlen(package->name) == name && strncmp(package->name, name_and_path, name) == 0) {
      return is_in(path, (int)strlen(package->folder), package->folder,
                   name_and_path + name + (name_and_path[name] == '/')) ||
             sepax_fail(error, SEPAX_ERROR_FORMAT, "no file %.120s in package folder %.80s",
                        name_and_path, package->folder);
    }
  }
  char folder[PATH_MOST] = "";
  if (search_package(path, p->urdf, name_and_path, folder)) {
    return true;
  }
  if (folder[0] != '\0') {
    return sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "no file %.120s in package folder %.80s; mend the name, or give --package",
                      name_and_path, folder);
  }
  return sepax_fail(error, SEPAX_ERROR_FORMAT,
                    "package://%.100s is neither beside the URDF nor above it; give "
                    "--package=%.*s:FOLDER",
                    name_and_path, (int)(name < 40 ? name : 40), name_and_path);
}

static bool find_here(const mesh_places *p, const char *name, char *path, sepax_error *error) {
  static const char scheme[] = "file://";
  bool is_url = strncmp(name, scheme, strlen(scheme)) == 0;
  const char *file = is_url ? name + strlen(scheme) : name;
  if (strstr(file, "://") != NULL) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "%.120s is not fetched from a network; give a file", name);
  }
  const char *slash = strrchr(p->urdf, '/');
  bool whole = file[0] == '/' || slash == NULL;
  bool found = whole ? snprintf(path, PATH_MOST, "%s", file) < PATH_MOST && is_file(path)
                     : is_in(path, (int)(slash - p->urdf), p->urdf, file);
  return found ||
         sepax_fail(error, SEPAX_ERROR_FORMAT, "mesh %.160s: no such file; mend the name", name);
}

bool sepax__find_mesh(const mesh_places *places, const char *name, char **path,
                      sepax_error *error) {
  static const char scheme[] = "package://";
  char found[PATH_MOST];
  bool packaged = strncmp(name, scheme, strlen(scheme)) == 0;
  if (!(packaged ? find_in_package(places, name + strlen(scheme), found, error)
                 : find_here(places, name, found, error))) {
    return false;
  }
  *path = copy_of(found);
  return *path != NULL || sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for a name");
}
