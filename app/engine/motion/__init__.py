"""How a cycle is described and solved."""
