# SPDX-License-Identifier: MIT
# The front door. Everything real happens in CMake; see CMakePresets.json for the configurations.

PRESET ?= release
BUILD  := build/$(PRESET)
JOBS   ?= $(shell nproc 2>/dev/null || echo 2)
PREFIX ?= /usr/local
SEAWAY := $(BUILD)/bin/seaway
SETUP  := $(if $(filter core,$(PRESET)),core)

.DEFAULT_GOAL := build
.NOTPARALLEL:
.PHONY: help setup configure build demo test bench format docs install clean

help: ## Show this list
	@echo "make [target] [PRESET=release|core|debug|asan|tsan|coverage|clang-release|...] [JOBS=N]"
	@awk -F ':.*## ' '/^[a-z]+:.*## / { printf "  %-10s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

setup: ## Install the Debian packages that are missing (asks for root only then)
	@scripts/setup $(SETUP)

configure:
	@cmake --preset $(PRESET) $(CMAKE_ARGS) --log-level=NOTICE

build: configure ## Build the library, the programs, the examples and the tests (the default)
	@cmake --build $(BUILD) -j $(JOBS)

demo: setup build ## A measured sea: in a window, or without a display as a picture and a video in out/
	@scripts/demo $(SEAWAY)

test: setup build ## Run every test
	@ctest --test-dir $(BUILD) --output-on-failure --no-tests=error -j $(JOBS)

bench: build ## Measure: the core against FFTW, the queries, the GPU passes
	@scripts/bench $(BUILD)

format: ## Lay out the code as .clang-format says
	@scripts/format

docs: build ## Write the pages of the verbs, of scenes' keys and of the truth tests, then check links and code in the docs
	@scripts/make_cli_docs $(SEAWAY) docs/cli.md
	@scripts/make_scene_docs $(BUILD)
	@scripts/make_validation $(BUILD) docs/validation.md
	@python3 scripts/check_docs.py

install: build ## Install to PREFIX (default /usr/local) below DESTDIR
	@DESTDIR="$(DESTDIR)" cmake --install $(BUILD) --prefix "$(PREFIX)"

clean: ## Remove build/ of every configuration; out/ stays
	@rm -rf build
