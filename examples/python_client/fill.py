#!/usr/bin/env python3
"""Fills a scene on a cluster and prints how it went: fill.py HOST:PORT SCENE OUT

mkdir -p gen && protoc -I proto --python_out=gen --grpc_out=gen --plugin=protoc-gen-grpc=$(which grpc_python_plugin) \
  proto/tilemend/v1/*.proto, then PYTHONPATH=gen. Debian: protobuf-compiler-grpc, python3-grpcio, python3-protobuf.
It speaks plain text. For TLS change the line with `insecure_channel`, as the comment there says.
"""
import json
import sys
import uuid

import grpc
from tilemend.v1 import job_spec_pb2, jobs_pb2, jobs_pb2_grpc

address, scene, out = sys.argv[1:]
# With TLS: grpc.secure_channel(address, grpc.ssl_channel_credentials(ca, key, cert)), with the bytes of these files.
channel = grpc.insecure_channel(address)
jobs = jobs_pb2_grpc.JobsStub(channel)
spec = job_spec_pb2.JobSpec(scene=scene, out=out)
job = jobs.CreateJob(jobs_pb2.CreateJobRequest(spec=spec, request_id=str(uuid.uuid4())))
while job.state == jobs_pb2.RUNNING:  # a watch may end before the job, to make room for others
    for job in jobs.WatchJob(jobs_pb2.WatchJobRequest(name=job.name, cursor=job.cursor)):
        print(f'{job.progress.phase}: {job.progress.tasks_done} of {job.progress.tasks} tasks', file=sys.stderr)
if not job.report:
    sys.exit(f'{job.name}: {jobs_pb2.JobState.Name(job.state)}: {job.error.message}')
with open(job.report) as report:
    print(json.dumps(json.load(report)['filled']))
