// Stop is sent whatever else is going on; where nobody hears it, that is said aloud.
import { act } from '../act'
import { announce } from '../announce'
import { desk } from '../desk.svelte'
import { Refusal } from '../refusal'
import { showRefusal } from '../refused.svelte'
import { t } from '../texts/index.svelte'

export function stopEverything(): void {
  if (desk.isLinked) {
    announce(t('stop.sent'))
    void act({ t: 'Stop' }).then((answer) => {
      if (typeof answer === 'string') announce(answer) // there was nothing to stop
    })
    return
  }
  announce(t('stop.unheard'))
  showRefusal(new Refusal(t('stop.unheard')), { x: window.innerWidth, y: 40 })
}
