// Where the bytes of a mesh come from, by the name of its content: the environment, or whoever stands for it.

async function fetched(name: string): Promise<ArrayBuffer | undefined> {
  const answer = await fetch(`/mesh/${name}`).catch(() => undefined)
  return answer?.ok ? answer.arrayBuffer().catch(() => undefined) : undefined
}

export const meshBytes: { of: (name: string) => Promise<ArrayBuffer | undefined> } = { of: fetched }
