/* SPDX-License-Identifier: MIT */
/* process.c - a Python program in a process of its own. */
#include "nc/process.h"
#include "util/error.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { ARGUMENTS_MOST = 16, NOT_STARTED = 127 };

/* In the child: becomes python3. -I keeps the user's own modules out, -B writes no files. */
static _Noreturn void become(const char *program, const char *const *arguments, int out,
                             int errors) {
  char *words[ARGUMENTS_MOST + 5] = {"python3", "-I", "-B", "-c", (char *)program};
  int count = 5;
  for (; *arguments != NULL && count < ARGUMENTS_MOST + 4; arguments++) {
    words[count++] = (char *)*arguments;
  }
  words[count] = NULL;
  if (dup2(out, STDOUT_FILENO) >= 0 && dup2(errors, STDERR_FILENO) >= 0) {
    /* The modules of Debian's packages belong to Debian's Python, which finds them by its name. */
    char *name = words[0];
    words[0] = "/usr/bin/python3";
    execv(words[0], words);
    words[0] = name;
    execvp(words[0], words);
  }
  _exit(NOT_STARTED);
}

bool nc_process_start(nc_process *p, const char *program, const char *const *arguments,
                      sepax_error *error) {
  int ends[2] = {-1, -1};
  *p = (nc_process){.errors = tmpfile(), .pid = -1};
  if (p->errors == NULL || pipe(ends) != 0) {
    sepax_fail(error, SEPAX_ERROR_FILE, "a process cannot be started: %s", strerror(errno));
    if (p->errors != NULL) {
      fclose(p->errors);
    }
    return false;
  }
  fflush(NULL);
  p->pid = fork();
  if (p->pid == 0) {
    close(ends[0]);
    become(program, arguments, ends[1], fileno(p->errors));
  }
  close(ends[1]);
  p->out = fdopen(ends[0], "r");
  if (p->pid > 0 && p->out != NULL) {
    return true;
  }
  sepax_fail(error, SEPAX_ERROR_FILE, "a process cannot be started: %s", strerror(errno));
  if (p->out == NULL) {
    close(ends[0]);
  }
  bool failed;
  sepax_error more = {0};
  nc_process_end(p, &failed, &more);
  return false;
}

/* The last line with a word in it. */
static void last_line(FILE *in, char *line, size_t size) {
  char text[1024];
  line[0] = '\0';
  rewind(in);
  while (fgets(text, sizeof text, in) != NULL) {
    text[strcspn(text, "\n")] = '\0';
    if (strspn(text, " \t\r") < strlen(text)) {
      snprintf(line, size, "%.400s", text);
    }
  }
}

bool nc_process_end(nc_process *p, bool *failed, sepax_error *error) {
  char line[480] = "";
  int status = 0;
  if (p->out != NULL) {
    bool at_end = feof(p->out) != 0;
    fclose(p->out);
    if (!at_end && p->pid > 0) {
      kill(p->pid, SIGTERM);
    }
  }
  while (p->pid > 0 && waitpid(p->pid, &status, 0) < 0 && errno == EINTR) {}
  last_line(p->errors, line, sizeof line);
  fclose(p->errors);
  *failed = p->pid > 0 && WIFEXITED(status) && WEXITSTATUS(status) != 0;
  if (p->pid > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0) {
    return true;
  }
  if (*failed && WEXITSTATUS(status) == NOT_STARTED && line[0] == '\0') {
    return sepax_fail(error, SEPAX_ERROR_FILE, "python3 cannot be run; install python3");
  }
  return sepax_fail(error, SEPAX_ERROR_FORMAT, "%s",
                    line[0] != '\0' ? line : "the reader of NC programs ended without a word");
}
