"""Calls over HTTP/2 by hand, as no client library makes them: with a message of any length, or left with their answer."""
import select
import socket
import struct

DATA, HEADERS, RST_STREAM, SETTINGS, PING, GOAWAY, WINDOW_UPDATE = 0, 1, 3, 4, 6, 7, 8
END_STREAM, ACK, END_HEADERS = 1, 1, 4
INITIAL_WINDOW_SIZE = 4
STREAM = 1
PREFACE = b'PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n'
PIECE = bytes(16384)  # of a message; no frame may be longer


def frame(kind, flags, stream, payload=b''):
    return struct.pack('>I', len(payload))[1:] + struct.pack('>BBI', kind, flags, stream) + payload


def header_block(pairs):
    """HPACK without tables and without compression (RFC 7541, 6.2.2)."""
    return b''.join(bytes([0, len(name)]) + name.encode() + bytes([len(value)]) + value.encode() for name, value in pairs)


def call_headers(method, more=()):
    return header_block([(':method', 'POST'), (':scheme', 'http'), (':path', method), (':authority', 'coordinator'),
                         ('content-type', 'application/grpc'), ('te', 'trailers'), *more])


def compressed_call(port, method, encoding, message):
    """Sends one message that says it is compressed so, and waits until the peer has ended the call."""
    LongCall(port, method, [('grpc-encoding', encoding)]).send(len(message), message, flag=1)


def unread_calls(port, method, count):
    """A connection with so many calls of an empty message whose answers have no room."""
    connection = socket.create_connection(('127.0.0.1', port))
    connection.sendall(PREFACE + frame(SETTINGS, 0, 0, struct.pack('>HI', INITIAL_WINDOW_SIZE, 0)))
    for number in range(count):
        stream = 2 * number + 1
        connection.sendall(frame(HEADERS, END_HEADERS, stream, call_headers(method)) +
                           frame(DATA, END_STREAM, stream, bytes(5)))
    return connection


def begun_calls(port, method, count):
    """A connection with calls whose message is never complete: so many, or as many as the peer takes."""
    connection = socket.create_connection(('127.0.0.1', port))
    connection.sendall(PREFACE + frame(SETTINGS, 0, 0))
    connection.recv(9)  # its settings, which count once we say that we have them
    connection.sendall(frame(SETTINGS, ACK, 0))
    try:
        for number in range(count):
            connection.sendall(frame(HEADERS, END_HEADERS, 2 * number + 1, call_headers(method)) +
                               frame(DATA, 0, 2 * number + 1, struct.pack('>BI', 0, 100)))
    except ConnectionError:
        pass
    return connection


class LongCall:
    def __init__(self, port, method, more=()):
        self.socket = socket.create_connection(('127.0.0.1', port))
        self.windows = {0: 65535, STREAM: 65535}
        self.is_over = False
        self.socket.sendall(PREFACE + frame(SETTINGS, 0, 0) + frame(HEADERS, END_HEADERS, STREAM, call_headers(method, more)))

    def read(self, count):
        data = b''
        while len(data) < count:
            more = self.socket.recv(count - len(data))
            if not more:
                raise ConnectionError
            data += more
        return data

    def take_frame(self):
        head = self.read(9)
        kind, flags, stream = struct.unpack('>BBI', head[3:])
        payload = self.read(int.from_bytes(head[:3], 'big'))
        if kind == WINDOW_UPDATE:
            self.windows[stream] += struct.unpack('>I', payload)[0]
        elif kind == SETTINGS and not flags & ACK:
            for at in range(0, len(payload), 6):
                key, value = struct.unpack('>HI', payload[at:at + 6])
                if key == INITIAL_WINDOW_SIZE:
                    self.windows[STREAM] += value - 65535
            self.socket.sendall(frame(SETTINGS, ACK, 0))
        elif kind == PING and not flags & ACK:
            self.socket.sendall(frame(PING, ACK, 0, payload))
        elif kind in (RST_STREAM, GOAWAY) or (kind == HEADERS and flags & END_STREAM):
            self.is_over = True

    def put(self, piece):
        self.socket.sendall(frame(DATA, 0, STREAM, piece))
        for stream in self.windows:
            self.windows[stream] -= len(piece)

    def send(self, length, content=None, flag=0):
        """Sends a message of so many bytes, or this one, until the peer ends the call. The bytes that were sent."""
        sent = 0
        try:
            self.put(struct.pack('>BI', flag, length))
            while not self.is_over:
                room = min(self.windows.values())
                if room <= 0 or sent == length or select.select([self.socket], [], [], 0)[0]:
                    self.take_frame()
                    continue
                size = min(room, length - sent, len(PIECE))
                piece = PIECE[:size] if content is None else content[sent:sent + size]
                self.put(piece)
                sent += len(piece)
        except ConnectionError:
            pass
        self.socket.close()
        return sent
