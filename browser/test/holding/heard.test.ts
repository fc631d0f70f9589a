// What the environment says of who may move the robots is understood in Spanish.
import { expect, it } from 'vitest'
import { heard } from '../../src/texts/heard'

it.each([
  ['main: its holder ann#1 has been silent for 0.25 s', 'main: a ann#1, que lo tenía, no se le oyó durante 0.25 s'],
  ['ann#1 offers main no more: bob#2 declines', 'ann#1 ya no ofrece main: bob#2 la rechaza'],
  [
    'main is no longer offered to bob#2: no answer within 60 s',
    'main ya no está ofrecido a bob#2: sin respuesta en 60 s',
  ],
  [
    'play runs in flow0, flow1; ann#3 began it and is gone. Taken over, it is yours to let go on, or to end. Taking it over starts nothing and stops nothing',
    'play está en marcha en flow0, flow1; ann#3, que la inició, ya no está. Si se hace cargo, usted decide si sigue o termina. Hacerse cargo no inicia ni para nada',
  ],
  [
    'play ends: its tasks go off, its devices hold',
    'play termina: sus tareas se apagan, sus dispositivos se mantienen quietos',
  ],
  ['Take it over', 'Hacerse cargo'],
])('%s', (said, words) => expect(heard(said, 'es')).toBe(words))
