"""What a run says: metrics, energy account, claims."""
