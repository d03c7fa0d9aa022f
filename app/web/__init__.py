"""HTTP: JSON routers, HTML pages and what both share. The only place that knows status codes."""
