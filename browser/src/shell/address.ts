// The address of the page names what it shows: `#/config/joint_move?task=pd`, `#/appl/assemble`.

export interface Place {
  kind: 'config' | 'appl'
  name: string
  /** The task that is picked in a configuration. */
  task: string
}

export function read(hash: string): Place | undefined {
  const match = /^#\/(config|appl)\/([^?]+)(?:\?(.*))?$/.exec(hash) ?? /^#(appl)=([^?]+)$/.exec(hash)
  if (!match) return undefined
  const kind = match[1] === 'appl' ? 'appl' : 'config'
  return { kind, name: decoded(match[2]!), task: new URLSearchParams(match[3] ?? '').get('task') ?? '' }
}

export function written({ kind, name, task }: Place): string {
  return `#/${kind}/${encodeURIComponent(name)}${task ? `?task=${encodeURIComponent(task)}` : ''}`
}

function decoded(text: string): string {
  try {
    return decodeURIComponent(text)
  } catch {
    return text
  }
}
