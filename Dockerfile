# Two stages: the first installs with the pinned versions, the second keeps only what runs.
FROM python:3.11-slim-bookworm AS build
ENV PIP_NO_CACHE_DIR=1 PIP_DISABLE_PIP_VERSION_CHECK=1
WORKDIR /srv/drivewright
RUN python -m venv /opt/venv
# The libraries change rarely: their layer is built from the declaration alone and stays cached.
COPY pyproject.toml constraints.txt README.md ./
RUN mkdir app && touch app/__init__.py \
    && /opt/venv/bin/pip install -c constraints.txt -e '.[postgres]'

FROM python:3.11-slim-bookworm
LABEL org.opencontainers.image.title="Drivewright" \
      org.opencontainers.image.description="Select an electric drive, with every number open to its formula"
ENV PATH=/opt/venv/bin:$PATH \
    PYTHONUNBUFFERED=1 \
    PYTHONDONTWRITEBYTECODE=1 \
    DRIVEWRIGHT_HOST=0.0.0.0 \
    DRIVEWRIGHT_PORT=8000 \
    DRIVEWRIGHT_WORKERS=2
WORKDIR /srv/drivewright
RUN useradd --system --uid 10001 --home-dir /srv/drivewright --shell /usr/sbin/nologin drivewright \
    && install -d -o drivewright -g drivewright var
COPY --from=build /opt/venv /opt/venv
# What is copied is listed in .dockerignore.
COPY . .
USER drivewright
# Without DATABASE_URL the data are an SQLite file in this folder.
VOLUME /srv/drivewright/var
EXPOSE 8000
HEALTHCHECK --interval=15s --timeout=5s --start-period=60s --retries=3 \
    CMD ["python", "-c", "import os, urllib.request as u; u.urlopen('http://127.0.0.1:' + os.environ['DRIVEWRIGHT_PORT'] + '/healthz', timeout=4)"]
ENTRYPOINT ["/srv/drivewright/tools/container_start.sh"]
CMD ["drivewright", "serve"]
