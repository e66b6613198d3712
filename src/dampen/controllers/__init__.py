"""Who decides: the law at the ports and what it learns between trials."""
