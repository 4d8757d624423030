// An S3 server with a proxy before it that spoils answers. `node server.cjs PACKAGES FOLDER BUCKET` prints the port of
// the proxy. PUT /-/faults takes a JSON list of {method, match, times, kind}: the next `times` requests of that method
// whose URL has `match` in it are answered by 503 ("busy"), cut in the middle ("cut"), held back for a second ("slow")
// or get another byte ("flip"). GET /-/faults answers those that are left, GET /-/log the requests.
const http = require('node:http')
const path = require('node:path')

// s3rver leaves "+" encoded in the names of what is copied, and then does not find it. Amazon's service decodes all.
globalThis.decodeURI = decodeURIComponent

const [packages, directory, bucket] = process.argv.slice(2)
const S3rver = require(path.join(packages, 'node_modules', '@20minutes', 's3rver'))

let faults = []
const log = []

function faultOf(request) {
  const fault = faults.find((f) => f.times > 0 && f.method === request.method && request.url.includes(f.match))
  if (fault) fault.times -= 1
  return fault ? fault.kind : ''
}

function bodyOf(request, then) {
  const parts = []
  request.on('data', (part) => parts.push(part))
  request.on('end', () => then(Buffer.concat(parts)))
}

function spoil(kind, answer, from, body) {
  const headers = { ...from.headers, 'content-length': from.headers['content-length'] ?? body.length }
  answer.writeHead(from.statusCode, headers)
  if (kind === 'cut') {
    answer.write(body.subarray(0, body.length / 2))
    setTimeout(() => answer.socket.destroy(), 20)
    return
  }
  if (kind === 'flip' && body.length > 0) body[body.length >> 1] ^= 1
  answer.end(body)
}

function relay(port, request, answer) {
  const kind = faultOf(request)
  log.push({ method: request.method, url: request.url, headers: request.headers, fault: kind })
  bodyOf(request, (body) => {
    if (kind === 'busy') {
      answer.writeHead(503)
      answer.end('<Error><Code>SlowDown</Code></Error>')
      return
    }
    if (kind === 'flip' && request.method === 'PUT' && body.length > 0) body[body.length >> 1] ^= 1
    const send = () => {
      const { method, url, headers } = request
      const onward = http.request({ port, method, path: url, headers }, (from) => {
        bodyOf(from, (got) => spoil(request.method === 'GET' ? kind : kind === 'cut' ? 'cut' : '', answer, from, got))
      })
      onward.on('error', () => answer.destroy())
      onward.end(body)
    }
    setTimeout(send, kind === 'slow' ? 1000 : 0)
  })
}

async function main() {
  const server = new S3rver({ port: 0, address: '127.0.0.1', silent: true, directory, configureBuckets: [{ name: bucket }] })
  const { port } = await server.run()
  const proxy = http.createServer((request, answer) => {
    if (request.url === '/-/log') return answer.end(JSON.stringify(log))
    if (request.url !== '/-/faults') return relay(port, request, answer)
    if (request.method === 'GET') return answer.end(JSON.stringify(faults))
    return bodyOf(request, (body) => {
      faults = JSON.parse(body)
      answer.end()
    })
  })
  proxy.listen(0, '127.0.0.1', () => console.log(proxy.address().port))
}

main()
