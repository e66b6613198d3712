"""What vibrates: each plant turns its physics into modes, ports and fields."""
