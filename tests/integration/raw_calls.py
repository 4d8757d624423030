"""A call with a message of any length, over HTTP/2 by hand: client libraries would not send it, or hold it in memory."""
import select
import socket
import struct

DATA, HEADERS, RST_STREAM, SETTINGS, PING, GOAWAY, WINDOW_UPDATE = 0, 1, 3, 4, 6, 7, 8
END_STREAM, ACK, END_HEADERS = 1, 1, 4
INITIAL_WINDOW_SIZE = 4
STREAM = 1
PIECE = bytes(16384)  # of a message; no frame may be longer


def frame(kind, flags, stream, payload=b''):
    return struct.pack('>I', len(payload))[1:] + struct.pack('>BBI', kind, flags, stream) + payload


def header_block(pairs):
    """HPACK without tables and without compression (RFC 7541, 6.2.2)."""
    return b''.join(bytes([0, len(name)]) + name.encode() + bytes([len(value)]) + value.encode() for name, value in pairs)


class LongCall:
    def __init__(self, port, method):
        self.socket = socket.create_connection(('127.0.0.1', port))
        self.windows = {0: 65535, STREAM: 65535}
        self.is_over = False
        block = header_block([(':method', 'POST'), (':scheme', 'http'), (':path', method), (':authority', 'coordinator'),
                              ('content-type', 'application/grpc'), ('te', 'trailers')])
        self.socket.sendall(b'PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n' + frame(SETTINGS, 0, 0) +
                            frame(HEADERS, END_HEADERS, STREAM, block))

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

    def send(self, length):
        """Sends a message of so many bytes until it is there, or the peer ends the call. The bytes that were sent."""
        sent = 0
        try:
            self.put(struct.pack('>BI', 0, length))
            while not self.is_over:
                room = min(self.windows.values())
                if room <= 0 or sent == length or select.select([self.socket], [], [], 0)[0]:
                    self.take_frame()
                    continue
                piece = PIECE[:min(room, length - sent)]
                self.put(piece)
                sent += len(piece)
        except ConnectionError:
            pass
        self.socket.close()
        return sent
