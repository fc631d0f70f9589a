// Stop is sent whatever else is going on; where nobody hears it, that is said aloud, and it goes out with the first
// chance: to stop late harms nobody.
import { act } from '../act/act'
import { announce } from '../state/announce'
import { desk } from '../link/desk.svelte'
import { hear, send } from '../link/link'
import { Refusal } from '../link/refusal'
import { hideRefusal, showRefusal } from '../act/refused.svelte'
import { plain, say, type Reason } from '../texts/say'
import { t } from '../texts/index.svelte'
import { stopRequest } from './stopRequest.svelte'

export function stopEverything(): void {
  if (desk.isLinked) {
    hideRefusal()
    announce(t('stop.sent'))
    void ask()
    return
  }
  stopRequest.isUnsent = true
  announce(t('stop.unheard'))
  showRefusal(new Refusal(plain(t('stop.unheard'))), { x: window.innerWidth, y: 40 })
}

/** Motion is allowed again wherever all is stopped. */
export function allowMotion(): Promise<unknown> {
  return act({ t: 'Reset', ...(Object.keys(desk.live.stations).length ? { is_everywhere: true } : {}) })
}

async function ask(): Promise<void> {
  stopRequest.begin()
  try {
    const answer = await send({ t: 'Stop' })
    stopRequest.answered()
    if (answer) announce(say(answer as Reason)) // there was nothing to stop
  } catch (why) {
    stopRequest.failed()
    if (!(why instanceof Refusal)) throw why
    if (!desk.isLinked) stopRequest.isUnsent = true // nobody knows whether it was heard: it is said again
    showRefusal(desk.isLinked ? why : new Refusal(plain(t('stop.unheard'))), { x: window.innerWidth, y: 40 })
    announce(why.reason)
  }
}

hear('Snapshot', () => {
  if (!stopRequest.isUnsent) return
  stopRequest.isUnsent = false
  hideRefusal()
  announce(t('stop.sent'))
  void ask()
})
