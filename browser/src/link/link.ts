// The one connection to the environment: acts go out, each comes back answered once; everything else is passed on.
import type { AnyAct, AnyMessage } from '../api.gen'
import { applyPatch, applySnapshot, desk } from './desk.svelte'
import { message } from './message'
import { Refusal } from './refusal'
import { t } from '../texts/index.svelte'
import { plain } from '../texts/say'

/** What a WebSocket offers that is used here. */
export interface Carrier {
  onopen: ((event: never) => unknown) | null
  onclose: ((event: never) => unknown) | null
  onmessage: ((event: { data: string }) => unknown) | null
  send(text: string): void
  close(): void
}

type Ear = (message: never) => void
interface Waiting {
  done(value: unknown): void
  refused(why: Refusal): void
}

const FIRST_PAUSE_MS = 300
const LONGEST_PAUSE_MS = 10_000

export class Link {
  private carrier: Carrier | undefined
  private lastCid = 0
  private waiting = new Map<number, Waiting>()
  private ears = new Map<string, Set<Ear>>()
  private pause = FIRST_PAUSE_MS
  private timer: ReturnType<typeof setTimeout> | undefined

  /** `isLocked` asks whether the environment is there and will not have this browser. */
  constructor(
    private open: () => Carrier | Promise<Carrier>,
    private readonly isLocked: () => Promise<boolean> = () => Promise.resolve(false),
  ) {}

  /** Start, over another way than usual. */
  startFrom(open: () => Carrier | Promise<Carrier>): Promise<void> {
    this.open = open
    return this.start()
  }

  async start(): Promise<void> {
    clearTimeout(this.timer)
    let carrier: Carrier
    try {
      carrier = await this.open()
    } catch {
      return this.again()
    }
    this.carrier = carrier
    carrier.onmessage = ({ data }) => this.take(message(data))
    carrier.onclose = () => this.lost(carrier)
  }

  /** Resolves with the value of the answer, or rejects with a Refusal. */
  send(act: AnyAct): Promise<unknown> {
    const carrier = this.carrier
    if (!desk.isLinked || !carrier) return Promise.reject(new Refusal(plain(t('link.lost'))))
    const cid = ++this.lastCid
    return new Promise((done, refused) => {
      this.waiting.set(cid, { done, refused })
      carrier.send(JSON.stringify({ cid, act }))
    })
  }

  /** Hear every message of a kind from now on; the result ends it. */
  hear<K extends AnyMessage['t']>(kind: K, ear: (message: Extract<AnyMessage, { t: K }>) => void): () => void {
    const ears = this.ears.get(kind) ?? new Set()
    this.ears.set(kind, ears.add(ear as Ear))
    return () => ears.delete(ear as Ear)
  }

  private take(message: AnyMessage): void {
    if (message.t === 'Ok') this.settle(message.cid)?.done(message.value)
    else if (message.t === 'Refused') this.settle(message.cid)?.refused(Refusal.from(message))
    else if (message.t === 'Snapshot') this.begin(message)
    else if (message.t === 'Patch' && !applyPatch(message)) this.carrier?.close() // a gap: the next snapshot mends it
    for (const ear of this.ears.get(message.t) ?? []) ear(message as never)
  }

  private begin(message: Extract<AnyMessage, { t: 'Snapshot' }>): void {
    applySnapshot(message)
    desk.isLinked = true
    desk.isLocked = false
    this.pause = FIRST_PAUSE_MS
  }

  private settle(cid: number): Waiting | undefined {
    const waiting = this.waiting.get(cid)
    this.waiting.delete(cid)
    return waiting
  }

  private lost(carrier: Carrier): void {
    if (carrier !== this.carrier) return
    this.carrier = undefined
    if (!desk.isLinked) void this.isLocked().then((is) => (desk.isLocked = is))
    desk.isLinked = false
    for (const { refused } of this.waiting.values()) refused(new Refusal(plain(t('link.unanswered'))))
    this.waiting.clear()
    this.again()
  }

  private again(): void {
    this.timer = setTimeout(() => void this.start(), this.pause)
    this.pause = Math.min(this.pause * 1.7, LONGEST_PAUSE_MS)
  }
}

function openSocket(): Carrier | Promise<Carrier> {
  if (import.meta.env.DEV && new URLSearchParams(location.search).has('sample')) {
    return import('./sample').then((sample) => sample.carrier())
  }
  const address = new URL('ws', location.href)
  address.protocol = address.protocol === 'https:' ? 'wss:' : 'ws:'
  address.hash = ''
  return new WebSocket(address) as unknown as Carrier
}

/** After a new start the environment has a new key, and this browser's is void; or whoever is here has to sign in anew. */
async function isLocked(): Promise<boolean> {
  const answer = await fetch(location.pathname, { cache: 'no-store' }).catch(() => undefined)
  if (answer?.status === 401) location.reload()
  return answer?.status === 403
}

const link = new Link(openSocket, isLocked)

export const send = (act: AnyAct): Promise<unknown> => link.send(act)
export const start = (): Promise<void> => link.start()
/** Start with what stands for an environment. */
export const startFrom: Link['startFrom'] = (open) => link.startFrom(open)
export const hear: Link['hear'] = (kind, ear) => link.hear(kind, ear)
