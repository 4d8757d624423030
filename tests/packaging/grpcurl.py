#!/usr/bin/env python3
"""Stands in for grpcurl, which is no package of Debian: its commands list, describe and a call, by server reflection.

    grpcurl.py [-plaintext] [-cacert F] [-cert F -key F] [-H 'NAME: VALUE']... HOST:PORT list|describe [SYMBOL]
    grpcurl.py ... [-d JSON] [-proto F] HOST:PORT SERVICE/METHOD
"""
import argparse
import os
import subprocess
import sys
import tempfile

import grpc
from google.protobuf import descriptor_pb2, descriptor_pool, json_format, message_factory

SERVICE = 'grpc.reflection.v1alpha.ServerReflection'
# What is used here of github.com/grpc/grpc/blob/master/src/proto/grpc/reflection/v1alpha/reflection.proto
REFLECTION = '''
syntax = "proto3";
package grpc.reflection.v1alpha;
message Request { oneof of { string file_containing_symbol = 4; string list_services = 7; } }
message Files { repeated bytes file = 1; }
message Name { string name = 1; }
message Names { repeated Name service = 1; }
message Fault { int32 code = 1; string text = 2; }
message Response { oneof of { Files files = 4; Names services = 6; Fault fault = 7; } }
'''


def message_class(pool, name):
    return message_factory.MessageFactory(pool).GetPrototype(pool.FindMessageTypeByName(name))


def pool_of(path):
    """What the file declares. It imports no other."""
    made = subprocess.run(['protoc', f'-I{os.path.dirname(path) or "."}', '--descriptor_set_out=/dev/stdout', path],
                          stdout=subprocess.PIPE, check=True).stdout
    pool = descriptor_pool.DescriptorPool()
    pool.Add(descriptor_pb2.FileDescriptorSet.FromString(made).file[0])
    return pool


def reflection_pool():
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, 'reflection.proto')
        with open(path, 'w') as file:
            file.write(REFLECTION)
        return pool_of(path)


class Server:
    def __init__(self, options):
        read = lambda path: open(path, 'rb').read() if path else None
        if options.plaintext:
            self.channel = grpc.insecure_channel(options.address)
        else:
            self.channel = grpc.secure_channel(options.address, grpc.ssl_channel_credentials(
                read(options.cacert), read(options.key), read(options.cert)))
        self.metadata = [tuple(part.strip() for part in header.split(':', 1)) for header in options.headers]
        pool = reflection_pool()
        self.request = message_class(pool, 'grpc.reflection.v1alpha.Request')
        self.response = message_class(pool, 'grpc.reflection.v1alpha.Response')
        self.pool = pool_of(options.proto) if options.proto else descriptor_pool.DescriptorPool()
        self.is_reflected = not options.proto

    def ask(self, **question):
        call = self.channel.stream_stream(f'/{SERVICE}/ServerReflectionInfo', self.request.SerializeToString,
                                          self.response.FromString)
        answer = next(call(iter([self.request(**question)]), metadata=self.metadata))
        if answer.HasField('fault'):
            sys.exit(f'{question}: {answer.fault.text}')
        return answer

    def services(self):
        return sorted(service.name for service in self.ask(list_services='*').services.service)

    def load(self, symbol):
        """Adds the file of the symbol and those that it imports, which come with it in any order."""
        if not self.is_reflected:
            return
        files = [descriptor_pb2.FileDescriptorProto.FromString(file)
                 for file in self.ask(file_containing_symbol=symbol).files.file]
        known = set()
        while files:
            ready = [file for file in files if known.issuperset(file.dependency)]
            if not ready:
                sys.exit(f'{symbol}: reflection does not give what {files[0].name} imports')
            for file in ready:
                self.pool.Add(file)
                known.add(file.name)
                files.remove(file)

    def describe(self, symbol):
        self.load(symbol)
        for kind, find in (('message', self.pool.FindMessageTypeByName), ('service', self.pool.FindServiceByName),
                           ('enum', self.pool.FindEnumTypeByName)):
            try:
                found = find(symbol)
            except KeyError:
                continue
            proto = getattr(descriptor_pb2, {'message': '', 'enum': 'Enum', 'service': 'Service'}[kind] + 'DescriptorProto')()
            found.CopyToProto(proto)
            return f'{symbol} is a {kind}:\n{proto}'
        sys.exit(f'{symbol}: not found')

    def call(self, name, body):
        service, method = name.split('/')
        self.load(service)
        found = self.pool.FindServiceByName(service).FindMethodByName(method)
        make = lambda message: message_class(self.pool, message.full_name)
        kind = self.channel.unary_stream if found.server_streaming else self.channel.unary_unary
        call = kind(f'/{name}', make(found.input_type).SerializeToString, make(found.output_type).FromString)
        answer = call(json_format.Parse(body, make(found.input_type)(), descriptor_pool=self.pool), metadata=self.metadata)
        for message in answer if found.server_streaming else [answer]:
            print(json_format.MessageToJson(message, descriptor_pool=self.pool))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('-plaintext', action='store_true')
    for name in ('cacert', 'cert', 'key', 'proto'):
        parser.add_argument(f'-{name}')
    parser.add_argument('-H', dest='headers', action='append', default=[])
    parser.add_argument('-d', dest='body', default='{}')
    for name in ('address', 'verb'):
        parser.add_argument(name)
    parser.add_argument('symbol', nargs='?')
    options = parser.parse_args()
    server = Server(options)
    try:
        if options.verb == 'list' and not options.symbol:
            print('\n'.join(server.services()))
        elif options.verb == 'list':
            server.load(options.symbol)
            print('\n'.join(sorted(m.full_name for m in server.pool.FindServiceByName(options.symbol).methods)))
        elif options.verb == 'describe':
            print(server.describe(options.symbol))
        else:
            server.call(options.verb, options.body)
    except grpc.RpcError as error:
        print(f'ERROR:\n  Code: {error.code().name}\n  Message: {error.details()}', file=sys.stderr)
        sys.exit(64 + error.code().value[0])


if __name__ == '__main__':
    main()
