# Two commands: `make demo` and `make test`. Each sets up what it needs; later calls don't install again.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
STAMP := $(VENV)/.installed

.PHONY: setup demo test thorough check docs page bench figures clean-figures format clean

setup: $(STAMP)

$(STAMP): pyproject.toml constraints.txt
	@$(PYTHON) -c 'import sys; sys.path.insert(0, "."); from tandem.executive.cli.start import unsupported; sys.exit(unsupported(sys.version_info[:2]) or 0)'
	$(PYTHON) -m venv $(VENV)
	$(BIN)/pip install --quiet --disable-pip-version-check --constraint constraints.txt --editable '.[dev]'
	@touch $(STAMP)

demo: $(STAMP)
	$(BIN)/tandem demo

test: $(STAMP)
	$(BIN)/python -m pytest -n 2 --dist loadgroup

# What `make test` leaves out: whole tasks, minutes each, whose parts other tests cover.
thorough: $(STAMP)
	$(BIN)/python -m pytest -n 2 --dist loadgroup -m thorough

check: $(STAMP)
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/lint-imports

# The pages as a site: out/docs/index.html. A link that leads nowhere is an error.
docs: $(STAMP)
	$(BIN)/pip install --quiet --disable-pip-version-check --constraint constraints.txt --editable '.[docs]'
	$(BIN)/python -m sphinx --fail-on-warning --keep-going --quiet --builder html docs out/docs
	@echo "out/docs/index.html"

# The page's bundle, made anew from page/. Needs node and npm; the bundle is committed, so that users need neither.
page: $(STAMP)
	$(BIN)/python page/types_of_schemas.py page/src/types.ts
	cd page && npm ci --ignore-scripts --no-audit --no-fund --silent && npm run --silent check && npm run --silent build

bench: $(STAMP)
	$(BIN)/tandem bench

# Everything that docs/ tells in figures, made anew: some hours on two cores. A file that is there is not made
# again, so an interrupted `make figures` continues; `make clean-figures figures` begins anew.
FIGURES ?= out/figures
TANDEM := $(BIN)/tandem
EXPERIMENT = $(TANDEM) experiment
SERIES := --runs 60 --seed 1

$(FIGURES)/fetch.json:
	-$(TANDEM) campaign fetch $(SERIES) --report $@
$(FIGURES)/recovery.json:
	-$(TANDEM) campaign recovery $(SERIES) --hopeless 20 --report $@
$(FIGURES)/crash.json:
	-$(TANDEM) campaign crash --runs 200 --seed 1 --report $@
$(FIGURES)/crash-physics.json:
	-$(TANDEM) campaign crash --physics --seed 1 --report $@
$(FIGURES)/restart.json:
	-$(TANDEM) campaign restart --runs 10 --seed 1 --report $@
$(FIGURES)/soak.json:
	-$(TANDEM) campaign soak --tasks 2000 --report $@
$(FIGURES)/fuzz.json:
	-$(TANDEM) campaign fuzz --inputs 100000 --seed 1 --report $@
$(FIGURES)/uncoordinated.json:
	-$(EXPERIMENT) uncoordinated $(SERIES) --report $@
$(FIGURES)/uncoordinated-grasp.json:
	-$(EXPERIMENT) uncoordinated --series grasp $(SERIES) --report $@
$(FIGURES)/uncoordinated-planned-once.json:
	-$(EXPERIMENT) uncoordinated --method rrtconnect $(SERIES) --report $@
$(FIGURES)/uncoordinated-planned-again.json:
	-$(EXPERIMENT) uncoordinated --method rrtconnect_replan $(SERIES) --report $@
$(FIGURES)/crossing.json:
	-$(EXPERIMENT) crossing $(SERIES) --report $@
$(FIGURES)/crossing-faithful.json:
	-$(EXPERIMENT) crossing --mode faithful $(SERIES) --report $@
$(FIGURES)/crossing-sequential.json:
	-$(EXPERIMENT) crossing --sequential $(SERIES) --report $@
$(FIGURES)/coordinated.json:
	-$(EXPERIMENT) coordinated $(SERIES) --report $@

$(FIGURES)/rocs-1.json:
	-$(EXPERIMENT) rocs --case 1 $(SERIES) --report $@
$(FIGURES)/rocs-1-deliberative.json:
	-$(EXPERIMENT) rocs --case 1 --route deliberative $(SERIES) --report $@
$(FIGURES)/rocs-1-reactive.json:
	-$(EXPERIMENT) rocs --case 1 --route reactive $(SERIES) --report $@
$(FIGURES)/rocs-3-belief.json:
	-$(EXPERIMENT) rocs --case 3 --source belief $(SERIES) --report $@
$(FIGURES)/rocs-2.json:
	-$(EXPERIMENT) rocs --case 2 $(SERIES) --report $@
$(FIGURES)/rocs-3.json:
	-$(EXPERIMENT) rocs --case 3 $(SERIES) --report $@

# A command that misses its aim exits 1 and has written its file all the same: what was missed is published too.
MADE := $(shell sed -n 's|^$$(FIGURES)/\([a-z0-9-]*\)\.json:$$|$(FIGURES)/\1.json|p' $(firstword $(MAKEFILE_LIST)))

figures: $(STAMP) $(MADE)
	$(TANDEM) bench --markdown docs/benchmarks.md
	$(BIN)/python -m benchmarks.figures $(FIGURES) docs/campaigns.md docs/experiments.md docs/rocs.md

clean-figures:
	rm -rf $(FIGURES)

format: $(STAMP)
	$(BIN)/ruff format .
	$(BIN)/ruff check --fix .

clean:
	rm -rf $(VENV) build dist out *.egg-info
