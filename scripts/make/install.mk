# SPDX-License-Identifier: MIT
# install.mk - make install, make uninstall: programs, libraries, headers, manual pages; make dist:
# the source package.

VERSION = $(shell sed -n 's/.define SEPAX_VERSION_[A-Z]* \([0-9]*\)$$/\1/p' lib/sepax.h | \
            paste -sd.)
ROOT    = $(DESTDIR)$(PREFIX)
LIBDIR ?= lib
LIBRARIES = sepax sepax-io sepax-model
SHARED  = $(LIBRARIES:%=$(BUILD)/lib%.so.0)
HEADERS = $(wildcard lib/sepax*.h io/sepax*.h c_model/sepax*.h)
MAN     = share/man/man1/sepax.1 share/man/man1/sepax-certificate-check.1 \
          share/man/man3/libsepax.3
BIN     = sepax sepax-certificate-check
# The checker of certificates needs libxml2, libzip and libmd; where one is missing, it is left out.
PROGRAM = $(SEPAX) $(if $(and $(with_zip),$(with_md)),$(BUILD)/sepax-certificate-check)

.PHONY: install uninstall
install: $(PROGRAM) $(PUBLIC) $(SHARED)
	@case "$(PREFIX)" in *" "*) echo "install: PREFIX must be without blanks" >&2; exit 2 ;; /*) ;; \
	  *) echo "install: PREFIX=$(PREFIX) is not absolute; begin with /" >&2; exit 2 ;; esac
	@printf '%s\n' 'prefix=$(PREFIX)' 'includedir=$${prefix}/include' 'libdir=$${prefix}/$(LIBDIR)' \
	  'Name: sepax' 'Description: exact triangle/triangle collision detection' 'Version: $(VERSION)' \
	  'Cflags: -I$${includedir}' 'Libs: -L$${libdir} -lsepax' \
	  'Libs.private: -lm -pthread' > $(BUILD)/sepax.pc
	@sed -e 's/^Name: sepax/&-model/' -e 's/-lsepax/&-model/' \
	  -e 's/^Description: .*/Description: golden models of sepax hardware/' \
	  -e 's/^Libs.private: .*/Requires: sepax = $(VERSION)/' $(BUILD)/sepax.pc \
	  > $(BUILD)/sepax-model.pc
	@sed -e 's/^Name: sepax/&-io/' -e 's/-lsepax/&-io/' \
	  -e 's/^Description: .*/Description: meshes (STL, OBJ, PLY, 3MF, DAE), robots (URDF)/' \
	  -e 's/^Libs.private: .*/Libs.private: $(IO_LIBS)\nRequires: sepax = $(VERSION)/' \
	  $(BUILD)/sepax.pc > $(BUILD)/sepax-io.pc
	@for page in $(notdir $(MAN)); do \
	  sed 's/@VERSION@/$(VERSION)/' docs/man/$$page > $(BUILD)/$$page; done
	@install -d $(addprefix $(ROOT)/,bin include $(LIBDIR)/pkgconfig $(sort $(dir $(MAN))))
	@install -m 755 $(PROGRAM) $(ROOT)/bin
	@install -m 644 $(HEADERS) $(ROOT)/include
	@install -m 644 $(PUBLIC) $(SHARED) $(ROOT)/$(LIBDIR)
	@$(foreach name,$(LIBRARIES),ln -sf lib$(name).so.0 $(ROOT)/$(LIBDIR)/lib$(name).so &&) true
	@install -m 644 $(LIBRARIES:%=$(BUILD)/%.pc) $(ROOT)/$(LIBDIR)/pkgconfig
	@$(foreach page,$(MAN),install -m 644 $(BUILD)/$(notdir $(page)) $(ROOT)/$(page) &&) true
	@echo "installed in $(ROOT)"

uninstall:
	@rm -f $(addprefix $(ROOT)/,$(addprefix bin/,$(BIN)) \
	  $(addprefix include/,$(notdir $(HEADERS))) $(MAN) \
	  $(foreach name,$(LIBRARIES),$(addprefix $(LIBDIR)/,$(addprefix lib$(name).,a so so.0) \
	  pkgconfig/$(name).pc)))
	@case "$(ROOT)" in /usr | /usr/local) ;; *) \
	  for folder in $(addprefix $(ROOT)/,$(LIBDIR)/pkgconfig $(LIBDIR) lib include bin \
	    $(sort $(dir $(MAN))) share/man share) $(ROOT); do \
	    rmdir "$$folder" 2> /dev/null || true; done ;; esac

# What is committed, less what only this project's own house needs (.gitattributes, export-ignore):
# the reference cores, the manual pages and the documents with it. The same commit, the same bytes.
.PHONY: dist
DIST = sepax-$(VERSION)
dist:
	@git rev-parse --git-dir > /dev/null 2>&1 || { if [ -e .git ]; then \
	  echo "dist: git does not read this checkout; if another user owns it, run git config" \
	    "--global --add safe.directory $(abspath .)"; \
	  else echo "dist: this is no git checkout; the package that it came from is the source" \
	    "package"; fi >&2; exit 2; }
	@[ -z "$$(git status --porcelain)" ] || { echo "dist: files are changed and not committed; \
	  commit them first" >&2; exit 2; }
	@mkdir -p $(BUILD)
	@git archive --format=tar --prefix=$(DIST)/ HEAD | gzip -9n > $(BUILD)/$(DIST).tar.gz.part
	@mv $(BUILD)/$(DIST).tar.gz.part $(BUILD)/$(DIST).tar.gz
	@sha256sum $(BUILD)/$(DIST).tar.gz
