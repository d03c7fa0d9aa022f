"""REST interface under ``/api/v1``: the same services as the pages, the same numbers."""
