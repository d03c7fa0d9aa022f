#!/bin/sh
# Start of the container: bring the database and the catalogue up to date (both change nothing where nothing is new),
# then become the server, so that it receives the signal to stop.
set -eu
if [ "$*" = "drivewright serve" ]; then
    drivewright migrate
    drivewright load-catalog
fi
exec "$@"
