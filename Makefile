# Drivewright: `make run` serves it, `make test` tests it; both prepare everything they need in .venv first.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip --quiet --disable-pip-version-check

.DEFAULT_GOAL := help
.PHONY: help run test lint format bench screenshot clean

help:  ## show this list
	@sed -n 's/^\([a-z]*\):.*## /  make \1: /p' $(MAKEFILE_LIST)

$(BIN)/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' \
		|| { echo "Python 3.11 or later is needed; name one with: make PYTHON=/path/to/python3"; exit 1; }
	@echo "Creating the environment in $(VENV) ..."
	@$(PYTHON) -m venv $(VENV)

# A stamp is newer than what it was installed from, so a second make has nothing to do.
$(VENV)/.runtime: pyproject.toml constraints.txt | $(BIN)/python
	@echo "Installing what Drivewright needs ..."
	@$(PIP) install -c constraints.txt -e '.[postgres]'
	@touch $@

$(VENV)/.tests: pyproject.toml constraints.txt | $(BIN)/python
	@echo "Installing Drivewright and what its tests need ..."
	@$(PIP) install -c constraints.txt -e '.[postgres,test]'
	@touch $@ $(VENV)/.runtime

run: $(VENV)/.runtime  ## prepare the database, load the catalogue, serve (PORT=8000)
	@$(BIN)/drivewright migrate
	@$(BIN)/drivewright load-catalog
	@exec $(BIN)/drivewright serve $(if $(PORT),--port $(PORT))

test: $(VENV)/.tests  ## run all tests, a real Chromium and PostgreSQL included
	@$(BIN)/python tools/ensure_chromium.py || true
	@$(BIN)/python -m pytest -n 2 --dist loadfile

lint: $(VENV)/.tests  ## check style and types
	@$(BIN)/ruff check .
	@$(BIN)/ruff format --check .
	@$(BIN)/mypy

format: $(VENV)/.tests  ## put the code into its standard form
	@$(BIN)/ruff check --fix --select I .
	@$(BIN)/ruff format .

bench: $(VENV)/.tests  ## measure the figures of benchmarks/ and print them as JSON
	@for file in benchmarks/[a-z]*.py; do $(BIN)/python $$file || exit 1; done

screenshot: $(VENV)/.tests  ## take the picture of the README again (PAGE=/path of another page)
	@$(BIN)/python tools/ensure_chromium.py
	@$(BIN)/python tools/screenshot.py $(PAGE)

clean:  ## remove the environment and all caches, not the data
	@rm -rf $(VENV) build *.egg-info .pytest_cache .mypy_cache .ruff_cache .hypothesis
