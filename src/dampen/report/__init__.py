"""Report: figures and one self-contained page for a run."""

from dampen.report.write import write_report as write_report
