"""What stands between a command and the force that is delivered."""
