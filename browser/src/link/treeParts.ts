// Parts of the tree that hold very much: nobody watches each value in them, they are exchanged whole when they change.

/** How long the path of such a part is, by where it begins. */
const DEPTHS: Readonly<Record<string, number>> = {
  applications: 2,
  onikons: 1,
  types: 1,
  pictures: 1,
  edges: 1,
  module_sentences: 1,
}

type Branch = Record<string, unknown>

/** What is of a class of its own is not made watchable. */
class Part {
  [key: string]: unknown
  constructor(content: Branch) {
    Object.assign(this, content)
  }
}

const asPart = (content: unknown): Part => new Part((content ?? {}) as Branch)

/** The tree with such parts in it. */
export function withParts<T extends object>(tree: T): T {
  const all = { ...tree } as Branch
  for (const [name, depth] of Object.entries(DEPTHS)) {
    const there = (all[name] ?? {}) as Branch
    all[name] =
      depth === 1
        ? asPart(there)
        : Object.fromEntries(Object.entries(there).map(([key, content]) => [key, asPart(content)]))
  }
  return all as T
}

/** Changes of one patch; a part is copied once for all of them, and so is what in it is on the way to a change. */
export class Exchange {
  private readonly parts = new Map<string, { path: readonly string[]; part: Part | null }>()
  private readonly own = new Set<unknown>()

  constructor(private readonly tree: object) {}

  /** Whether it is a change of such a part, which is then noted. */
  take(path: readonly string[], value: unknown): boolean {
    const depth = DEPTHS[path[0] ?? '']
    if (depth === undefined || path.length < depth) return false
    const root = path.slice(0, depth)
    if (path.length === depth) this.note(root, value === null && depth > 1 ? null : asPart(value))
    else this.within(root, path.slice(depth), value)
    return true
  }

  /** Put the parts that have changed into the tree. */
  finish(): void {
    for (const { path, part } of this.parts.values()) {
      const [name = '', key] = path
      const tree = this.tree as Branch
      if (key === undefined) tree[name] = part
      else if (part === null) delete (tree[name] as Branch)[key]
      else (tree[name] as Branch)[key] = part
    }
  }

  private note(path: readonly string[], part: Part | null): Part | null {
    this.parts.set(path.join('\n'), { path, part })
    this.own.add(part)
    return part
  }

  private within(root: readonly string[], path: readonly string[], value: unknown): void {
    let branch: Branch | null = this.parts.get(root.join('\n'))?.part ?? null
    branch ??= this.note(root, asPart(root.reduce<unknown>((at, key) => (at as Branch | undefined)?.[key], this.tree)))
    for (const key of path.slice(0, -1)) {
      let next = (branch as Branch)[key] as Branch | undefined | null
      if (!next && value === null) return
      if (!next || !this.own.has(next)) {
        next = { ...next }
        this.own.add(next)
        ;(branch as Branch)[key] = next
      }
      branch = next
    }
    const last = path.at(-1)!
    if (value === null) delete (branch as Branch)[last]
    else (branch as Branch)[last] = value
  }
}
