"""Report: figures and one self-contained page for a run. Its face is `dampen.report.write`: drawing costs an import."""
