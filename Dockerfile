# Camarón for ParaView in a container, for machines that have an engine rather than ParaView:
#   docker build -t camaron .
#   docker run --rm -u "$(id -u):$(id -g)" -v "$PWD:$PWD" -w "$PWD" camaron inspect mesh.visf
FROM debian:13

COPY Scripts/launcher /opt/camaron/Scripts/launcher
RUN apt-get update \
  && sed 's/#.*//' /opt/camaron/Scripts/launcher/packages.txt \
    | DEBIAN_FRONTEND=noninteractive xargs apt-get install -y --no-install-recommends \
  && /opt/camaron/Scripts/launcher/link-modules.sh \
  && rm -rf /var/lib/apt/lists/*

COPY . /opt/camaron
RUN rm -rf /opt/camaron/build && /opt/camaron/camaron build && chmod -R a+rX /opt/camaron \
  && rm -rf /root/.cache
# All ranks are in the container.
ENV OMPI_MCA_btl=^tcp,ofi
ENTRYPOINT ["/opt/camaron/camaron"]
