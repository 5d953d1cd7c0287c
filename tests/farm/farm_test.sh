#!/usr/bin/env bash
# scripts/farm on a Slurm of one host: farm_test.sh DSPHERE SOURCE. Exit code 77: there is no Slurm here.
set -euo pipefail
DSPHERE=$(realpath "$1")
source=$2
export DSPHERE
for command in slurmctld slurmd sbatch squeue scontrol; do
    command -v $command >/dev/null || { echo "skipped: $command is missing (Debian: slurm-wlm)"; exit 77; }
done
((EUID == 0)) || { echo "skipped: a Slurm of the test's own runs as root alone"; exit 77; }

# shellcheck source=tests/farm/slurm
source "$source/tests/farm/slurm"
folder=$(mktemp -d)
trap 'stop_slurm; rm -rf "$folder"' EXIT
fail() {
    echo "FAILED: $*" >&2
    tail -n 20 "$folder"/film/*.log "$folder"/*.parts/*.log 2>/dev/null >&2 || true
    exit 1
}
# finished STATE: whether the last call's job that follows the tasks came to that end.
finished() { scontrol show job "$(<"$1/.farm/finish")" | grep --quiet "JobState=$2"; }
cd "$folder"
export XDG_CACHE_HOME=$folder/cache
cat >planet.pbrt <<'PBRT'
Scale -1 1 1
LookAt 0 0 4  0 0 0  0 1 0
Camera "perspective" "float fov" 40
Film "rgb" "string filename" "planet.exr" "integer xresolution" 96 "integer yresolution" 64
Sampler "independent" "integer pixelsamples" 32
Integrator "directlighting"
WorldBegin
LightSource "distant" "point3 from" [1 0 .5] "point3 to" [0 0 0]
Shape "displacedsphere" "string displacementfunction" "ripples" "float maxdispl" 8
PBRT
start_slurm "$folder/slurm" || fail "Slurm did not start"
farm=$source/scripts/farm

echo "-- a film: some of its renders are killed, and a task as a whole"
mkdir film whole
"$DSPHERE" render planet.pbrt --quiet --turntable 10 -o whole/f-%02d.png
"$farm" planet.pbrt -o film/f-%02d.png --frames 0-9 -- --turntable 10
"$farm" planet.pbrt -o film/f-%02d.png --frames 0-9 -- --turntable 10 | grep --quiet "still at work" ||
    fail "a second call submits again"
kill_one "$DSPHERE render planet.pbrt"
kill_one "$farm --task"
kill_one "$DSPHERE render planet.pbrt"
await_jobs || fail "the film's jobs do not end"
finished film COMPLETED || fail "the last job failed"
for frame in whole/*; do cmp "$frame" "film/${frame#whole/}" || fail "a frame is missing or another one"; done
grep --quiet "trying again" film/*.log || fail "no render was tried again"
grep --quiet "of 10 tasks are not done" film/*.log || fail "no task was submitted again"
"$farm" planet.pbrt -o film/f-%02d.png --frames 0-9 -- --turntable 10 | grep --quiet "nothing to do" ||
    fail "a second call does something"

echo "-- tiles and ranges of samples, a task and a render of them stopped, merged"
"$DSPHERE" render planet.pbrt --quiet -o whole.exr --reproducible --spp 2000
"$farm" planet.pbrt -o picture.exr --tiles 2 --spp 2000 --samples 2 -- --reproducible
stop_one "$DSPHERE render planet.pbrt" task
stop_one "$DSPHERE render planet.pbrt" render
await_jobs || fail "the picture's jobs do not end"
grep --quiet interrupted picture.parts/*.log || fail "no task was stopped"
grep --quiet "exit code 143; trying again" picture.parts/*.log || fail "a render that was stopped was not tried again"
finished picture.parts COMPLETED || fail "the merge failed"
cmp whole.exr picture.exr || fail "the merged picture is another one"

echo "-- a broken scene fails once, and nothing is merged"
echo 'Shape "cube"' >>planet.pbrt
"$farm" planet.pbrt -o broken.exr --tiles 20
await_jobs || fail "the broken scene's jobs do not end"
finished broken.parts CANCELLED || fail "the merge was not cancelled"
[[ ! -e broken.exr ]] || fail "a broken scene was merged"
! grep --quiet "trying again" broken.parts/*.log || fail "a broken scene was tried again"
failures=$(cat broken.parts/*.log | grep --count "dsphere: error: planet.pbrt:10:7: unknown shape" || true)
((failures >= 1 && failures <= 2)) || fail "the broken scene was rendered $failures times"

echo "-- by processes of this host, without Slurm"
if command -v parallel >/dev/null; then
    sed -i '$d' planet.pbrt
    "$farm" planet.pbrt -o 'here/f %d.png' --frames 1-2 --local 2 -- --turntable 10
    for frame in 1 2; do cmp whole/f-0$frame.png "here/f $frame.png" || fail "a frame of GNU parallel is another one"; done
    # An ssh of the test's own: a shell without this one's environment, in another folder; one host does not answer.
    mkdir bin
    cat >bin/ssh <<'SSH'
#!/bin/bash
while [[ $1 == -* ]]; do shift; done
[[ $1 == node ]] || exit 255
shift
[[ $1 != -- ]] || shift
echo node >>"$(dirname "$0")/calls"
cd / && exec env -i HOME="$HOME" PATH=/usr/bin:/bin USER=root SHELL=/bin/bash /bin/bash -c "$*"
SSH
    chmod +x bin/ssh
    printf '%s\n' : gone node >hosts
    PATH=$folder/bin:$PATH "$farm" planet.pbrt -o hosts.exr --tiles 3 --hosts hosts -- --reproducible ||
        fail "a host that does not answer ends all"
    "$DSPHERE" render planet.pbrt --quiet -o small.exr --reproducible
    cmp small.exr hosts.exr || fail "the picture of several hosts is another one"
    grep --quiet node bin/calls || fail "no other host was asked"
    echo 'Shape "cube"' >>planet.pbrt
    code=0
    "$farm" planet.pbrt -o broken-here.exr --tiles 20 --local 2 2>broken.log || code=$?
    ((code == 3)) || fail "a broken scene ends with exit code $code"
    [[ ! -e broken-here.exr ]] || fail "a broken scene was merged"
    failures=$(grep --count "dsphere: error: planet.pbrt:10:7: unknown shape" broken.log || true)
    ((failures >= 1 && failures <= 2)) || fail "the broken scene was rendered $failures times"
fi
echo "all is well"
