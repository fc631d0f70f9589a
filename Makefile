# Everything is set up on the first call: a virtual environment in .venv, and Onika in it.
# Another Python: make PYTHON=python3.12 demo

PYTHON ?= python3
SECONDS ?= 600
VENV   := .venv
BIN    := $(VENV)/bin
PEERS  := .venv-bench
AUDIT  := .venv-audit
SIDE_BY_SIDE := $(BIN)/python tools/side_by_side.py

# What is compiled is kept, also where the environment says otherwise: the tests start thousands of programs, and each
# would compile anew all it loads.
unexport PYTHONDONTWRITEBYTECODE

# Matrices here are small: threads of the linear algebra would only wait for each other.
export OPENBLAS_NUM_THREADS := 1

.DEFAULT_GOAL := help
.PHONY: help demo assemble page test tests check audit mutants fuzz soak bench bench-check bench-peers clean

help: ## say what can be made
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/make \1\t\2/p' $(MAKEFILE_LIST)

demo: $(VENV)/.installed page ## open the page on the laboratory of the box assembly
	$(BIN)/onika

assemble: $(VENV)/.installed ## assemble the four boxes, without the page
	$(BIN)/onika run assemble --expect 'LAMP == 1'

# Installing builds the page, but only when pyproject.toml changed; its own sources are compared here, in no time.
page: | $(VENV)/.installed ## build the page, if its sources changed
	@$(BIN)/python hatch_build.py

# Node looks at the page beside what Python looks at, in three processes: each uses one processor most of the time.
check: $(VENV)/.installed-dev page ## style, types, floors, tests for every file: a minute
	@$(SIDE_BY_SIDE) \
	  '$(BIN)/ruff check' \
	  '$(BIN)/ruff format --check' \
	  '$(BIN)/mypy' \
	  '$(BIN)/lint-imports' \
	  '$(BIN)/python tools/check_mirror.py' \
	  '$(BIN)/python tools/figures.py --check' \
	  '$(BIN)/python tools/requirements.py --check' \
	  '$(BIN)/python tools/generate.py --check' \
	  '$(BIN)/python tools/licences.py --check' \
	  '$(BIN)/python tools/bench/check.py' \
	  --behind '$(BIN)/python hatch_build.py check' \
	  --behind '$(BIN)/python hatch_build.py lint' \
	  --behind '$(BIN)/python hatch_build.py test'

audit: $(VENV)/.installed-dev ## ask the advisory databases about all packages, where a network allows
	$(BIN)/python tools/audit.py --venv $(AUDIT)

# The profile draws the same examples every time, so a change is judged by what it changed, and fifteen in a hundred of those
# that `soak` draws anew. What starts programs or browsers waits for the clock most of the time, so four at a time share two
# processors. What only computes goes on behind them, and gets what they leave. The first meet the machine's clock, and so do
# a few of the rest that start a process: what fails is tried twice more, and the summary names it as RERUN. A test that
# fails three times has a fault. In order of their folders, those with a browser come one after the other, and share it.
# Of three files of the safety core every fourth mutant is tried here; `mutants` tries all of every file.
SAMPLED := src/onika/ring/drive.py src/onika/runtime/transfer/input_guard.py src/onika/host/sessions/leases.py

TESTS := $(BIN)/pytest --hypothesis-profile=ci --dist=loadfile --reruns 2 -rR --durations=15 --durations-min=2

test: check ## the checks and all tests but the soak
	@$(MAKE) --no-print-directory tests

tests: $(VENV)/.installed-dev page
	@$(SIDE_BY_SIDE) \
	  '$(TESTS) --numprocesses=4 --no-loadscope-reorder -m "(site or page) and not slow"' \
	  --behind '$(TESTS) --numprocesses=2 -m "not slow and not site and not page"' \
	  --behind 'PYTHONPATH=tools $(BIN)/python -m mutation --every 4 $(SAMPLED)'

mutants: $(VENV)/.installed-dev ## plant a mutant in the safety core, thousands of times: a test has to notice each
	PYTHONPATH=tools $(BIN)/python -m mutation

fuzz: $(VENV)/.installed-dev ## random messages at every boundary, with new seeds, for SECONDS (600)
	$(BIN)/python tools/fuzz.py $(SECONDS)

soak: $(VENV)/.installed-dev ## the long tests, and every property on new examples
	$(BIN)/pytest -m slow
	$(BIN)/pytest -m "hypothesis and not slow"
	$(BIN)/python tools/fuzz.py $(SECONDS)

bench: $(VENV)/.installed-dev ## measure, and print what was measured
	@set -e; for each in $(sort $(wildcard tools/bench/*.py)); do echo "$$each"; PYTHONPATH=tests $(BIN)/python "$$each"; done
	@PYTHONPATH=tools/bench:tests $(BIN)/python -m beside --alone

bench-check: $(PEERS)/.installed ## compare what is counted and the ratios to the peers with what was kept last
	PYTHONPATH=tools/bench:tests $(PEERS)/bin/python tools/bench/check.py --ratios

bench-peers: $(PEERS)/.installed ## measure beside the peers, and write docs/benchmarks.md
	PYTHONPATH=tools/bench:tests $(PEERS)/bin/python -m beside --write docs/benchmarks.md

clean: ## remove what make made
	rm -rf $(VENV) $(PEERS) $(AUDIT) browser/node_modules src/onika/web/static build dist .mypy_cache .ruff_cache .pytest_cache .hypothesis .import_linter_cache
	find src tests tools -name __pycache__ -type d -prune -exec rm -rf {} +

$(VENV)/.installed: pyproject.toml | $(BIN)/pip
	$(BIN)/pip install --quiet --disable-pip-version-check --editable .
	@touch $@

# What is tried is compiled as it is loaded, which is a third of what is installed.
$(VENV)/.installed-dev: pyproject.toml | $(BIN)/pip
	$(BIN)/pip install --no-compile --quiet --disable-pip-version-check --editable ".[dev]"
	@touch $(VENV)/.installed $@

# Each peer is installed by itself: one that cannot be is named in the table, and harms no other.
$(PEERS)/.installed: pyproject.toml tools/bench/beside/peers.py | $(BIN)/pip
	$(BIN)/python -m venv --clear $(PEERS)
	$(PEERS)/bin/pip install --quiet --disable-pip-version-check --editable .
	PYTHONPATH=tools/bench:tests $(PEERS)/bin/python -m beside.peers
	@touch $@

# A venv that was left half made has no pip; it is made again.
$(BIN)/pip:
	@command -v $(PYTHON) >/dev/null || { \
	  echo "Onika needs Python 3.11 or newer, and there is no $(PYTHON). Name yours: make PYTHON=/path/to/python3" >&2; exit 1; }
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { \
	  echo "Onika needs Python 3.11 or newer, and $(PYTHON) is $$($(PYTHON) --version 2>&1). Name another: make PYTHON=python3.12" >&2; exit 1; }
	@$(PYTHON) -c 'import venv, ensurepip' 2>/dev/null || { \
	  echo "$(PYTHON) comes without its venv. On Debian and Ubuntu: apt-get install python3-venv" >&2; exit 1; }
	$(PYTHON) -m venv --clear $(VENV)
