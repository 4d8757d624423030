"""Single measurements of a long experiment, each kept in a file, so that a run that was interrupted goes on where it was."""
import hashlib
import json
import os
import sys


class Steps:
    """The measurements that were made with one program, in a folder of its own."""

    def __init__(self, folder, program):
        with open(program, 'rb') as file:
            self.folder = os.path.join(folder, hashlib.sha256(file.read()).hexdigest()[:12])
        os.makedirs(self.folder, exist_ok=True)

    def get(self, name, make, *arguments):
        """What `make` gave for that name, now or in an earlier run; anything that JSON can hold."""
        path = os.path.join(self.folder, name + '.json')
        if os.path.exists(path):
            with open(path, encoding='utf-8') as file:
                return json.load(file)
        print(f'  {name}', file=sys.stderr, flush=True)
        result = make(*arguments)
        with open(path + '.part', 'w', encoding='utf-8') as file:
            json.dump(result, file)
        os.replace(path + '.part', path)
        return result
