// The address of the page names what it shows: `#/config/joint_move?task=pd`.

export interface Place {
  config: string
  task: string
}

export function read(hash: string): Place | undefined {
  const found = /^#\/config\/([^?]+)(?:\?(.*))?$/.exec(hash)
  if (!found) return undefined
  return { config: decoded(found[1]!), task: new URLSearchParams(found[2] ?? '').get('task') ?? '' }
}

export function written({ config, task }: Place): string {
  return `#/config/${encodeURIComponent(config)}${task ? `?task=${encodeURIComponent(task)}` : ''}`
}

function decoded(text: string): string {
  try {
    return decodeURIComponent(text)
  } catch {
    return text
  }
}
