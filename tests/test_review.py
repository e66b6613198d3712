"""The review as it is written: audit.json and its schema, the page, the terminal."""

from __future__ import annotations

import json
import re
from pathlib import Path

import jsonschema
import pytest

import dampen
from dampen.analysis.audit.audit import audit
from dampen.analysis.credit import credit
from dampen.report.review import words
from dampen.studies.record import FILE, SCHEMA, plain, record, schema, write_record
from tests.test_shipped import SHIPPED

SHORT = ("--set", "task.trials=3", "--set", "numerics.modes=20", "--set", "numerics.step=0.002")
