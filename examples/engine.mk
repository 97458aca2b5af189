# SPDX-License-Identifier: MIT
# engine.mk - what the examples of engines share: sepax and its libraries by the project's Makefile,
# and the Verilog of DESIGN, which is made anew only where it is another.

$(SEPAX) $(LIB): FORCE
	@$(MAKE) -s --no-print-directory -C $(ROOT) build/$(@F)

$(ENGINE): $(SEPAX) FORCE
	@new=$(OUT)/new.$$$$ && mkdir -p $(@D) && trap 'rm -rf $$new' EXIT && \
	$(SEPAX) gen $(DESIGN) -o $$new > /dev/null && { diff -rq $$new $(@D) > /dev/null 2>&1 || \
	  { echo "  GEN     $(@D)"; rm -rf $(@D) && mv $$new $(@D); }; }
