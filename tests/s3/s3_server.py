"""An S3 server that checks signatures, with a proxy before it that spoils answers (server.cjs)."""
import json
import os
import subprocess
import sys
import urllib.request

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(os.path.dirname(HERE), 'web'))
from npm_packages import fail, install  # noqa: E402

BUCKET = 'tiles'
SECRET = 'S3RVER'  # of the server's only account, whose key has the same name


class S3Server:
    def __init__(self, packages, folder):
        install(packages, HERE)
        self.data = os.path.join(folder, 's3')
        os.makedirs(self.data)
        self.process = subprocess.Popen(['node', os.path.join(HERE, 'server.cjs'), packages, self.data, BUCKET],
                                        stdout=subprocess.PIPE, text=True)
        port = self.process.stdout.readline().strip()
        if not port:
            self.close()
            fail('the S3 server does not start')
        self.endpoint = f'http://127.0.0.1:{port}'

    def environment(self, **changes):
        kept = {name: value for name, value in os.environ.items() if not name.startswith('AWS_')}
        return kept | {'AWS_ENDPOINT_URL': self.endpoint, 'AWS_REGION': 'eu-central-1', 'AWS_ACCESS_KEY_ID': 'S3RVER',
                       'AWS_SECRET_ACCESS_KEY': SECRET, 'AWS_EC2_METADATA_DISABLED': 'true'} | changes

    def ask(self, path, body=None):
        request = urllib.request.Request(self.endpoint + path, body, method='PUT' if body else 'GET')
        return urllib.request.urlopen(request, timeout=20).read()

    def spoil(self, *faults):
        """Each is (method, what is in the URL, how often, kind)."""
        names = ('method', 'match', 'times', 'kind')
        self.ask('/-/faults', json.dumps([dict(zip(names, fault)) for fault in faults]).encode())

    def faults_left(self):
        return sum(fault['times'] for fault in json.loads(self.ask('/-/faults')))

    def requests(self):
        return json.loads(self.ask('/-/log'))

    def objects(self, prefix):
        """Contents by key, as they lie on the server's disk."""
        root = os.path.join(self.data, BUCKET)
        end = '._S3rver_object'
        found = {}
        for folder, _, names in os.walk(root):
            for name in names:
                key = os.path.relpath(os.path.join(folder, name), root)
                if key.endswith(end) and key.startswith(prefix):
                    found[key[len(prefix):-len(end)]] = open(os.path.join(folder, name), 'rb').read()
        return found

    def upload(self, folder, prefix):
        """Without a signature, which this server lets in for GET alone: as the files that it keeps."""
        for at, _, names in os.walk(folder):
            for name in names:
                path = os.path.join(at, name)
                to = os.path.join(self.data, BUCKET, prefix, os.path.relpath(path, folder))
                os.makedirs(os.path.dirname(to), exist_ok=True)
                open(to + '._S3rver_object', 'wb').write(open(path, 'rb').read())
                open(to + '._S3rver_metadata.json', 'w').write('{}')

    def drop(self, key):
        os.remove(os.path.join(self.data, BUCKET, key + '._S3rver_object'))

    def close(self):
        self.process.kill()
        self.process.wait()
