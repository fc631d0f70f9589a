// Español: frases que dice el entorno. Cada una por lo que es en inglés; lo que no está aquí queda en inglés.
// `{0}` es lo primero que varía; `{=0}`, si a su vez es una frase de estas, se traduce también.
import { esHeardDone } from './es.heard.done'
import { esHeardEdit } from './es.heard.edit'
import { esHeardHolding } from './es.heard.holding'
import { esHeardReview } from './es.heard.review'

export const esHeard: readonly (readonly [RegExp, string])[] = [
  // lo que hizo otro
  [
    /^“(.+)” in (.+) was done on another page, and is taken back here; Redo does it again$/,
    '«{=0}» en {1} se hizo en otra página, y aquí se deshace; Rehacer lo repite',
  ],
  [
    /^“(.+)” in (.+) was done on another page, and is done again here$/,
    '«{=0}» en {1} se hizo en otra página, y aquí se rehace',
  ],
  // qué le falta a una aplicación
  [/^flow (\d+) is empty$/, 'el flujo {0} está vacío'],
  [/^it has no flow$/, 'no tiene ningún flujo'],
  [/^an action is missing here$/, 'aquí falta una acción'],
  [/^an? (.+) target is missing here$/, 'aquí falta un objetivo {0}'],
  [
    /^nothing may end behind (.+): its edge fits no end$/,
    'nada puede terminar detrás de {0}: su borde no encaja con ningún final',
  ],
  [/^(.+) does not fit at the start$/, '{0} no encaja al principio'],
  [/^(.+) does not fit behind (.+)$/, '{0} no encaja detrás de {1}'],
  [/^(.+) wants a (.+) target behind it$/, '{0} necesita detrás un objetivo {1}'],
  [/^no action before (.+) takes it$/, 'ninguna acción antes de {0} lo admite'],
  [
    /^the condition (.+) at (.+) is none: compare a variable$/,
    'la condición {0} en {1} no lo es: compare una variable',
  ],
  [
    /^the loop (.+) is marked at one icon only; it has a test and an anchor$/,
    'el bucle {0} está marcado en un solo icono; necesita una prueba y un ancla',
  ],
  [
    /^the loops (.+) cross; one has to lie within the other$/,
    'los bucles {0} se cruzan; uno debe quedar dentro del otro',
  ],
  [
    /^a way round the loop (.+) takes no time: it needs a job$/,
    'una vuelta del bucle {0} no dura nada: necesita un trabajo',
  ],
  [
    /^the tag (.+) stands in one flow only: nobody would be met there$/,
    'la etiqueta {0} está en un solo flujo: nadie acudiría a ella',
  ],
  [
    /^the tag (.+) means nothing here: only parallel flows meet$/,
    'la etiqueta {0} no significa nada aquí: solo se encuentran los flujos paralelos',
  ],
  [
    /^flow(\d+) could wait at the tag (.+) in vain: flow(\d+) does not come there as often$/,
    'el flujo {0} podría esperar en vano en la etiqueta {1}: el flujo {2} no pasa por ella tantas veces',
  ],
  [/^(.+) is out of reach: (.+)$/, '{0} está fuera de alcance: {=1}'],
  [/^(.+) cannot be reached: (.+)$/, 'no se puede llegar a {0}: {=1}'],
  [/^(\S+) cannot come to (.+?): (.+)$/, '{0} no puede llegar a {1}: {=2}'],
  [
    /^the hand would lean (.+) degrees; this arm only holds it upright, fingers down$/,
    'la mano se inclinaría {0} grados; este brazo solo la sostiene vertical, con los dedos hacia abajo',
  ],
  [
    /^the wrist would be (.+) m from the shoulder, possible are (.+) m$/,
    'la muñeca quedaría a {0} m del hombro, son posibles {1} m',
  ],
  [/^joint (\d+) at (.+) rad is beyond (.+)$/, 'la articulación {0} a {1} rad pasa de {2}'],
  [/^(.+) does not suit (\S+): (.+)$/, '{0} no sirve para {1}: {=2}'],
  [/^nothing is known of (.+) from (\S+)$/, '{1} no dice nada de {0}'],
  [/^(\S+) does not write (.+), as (\S+) does$/, '{0} no escribe {1}, como hace {2}'],
  [/^(\S+) reads (.+), which no task of (\S+) writes$/, '{0} lee {1}, que ninguna tarea de {2} escribe'],
  [/^its device (\S+) is claimed by (\S+)$/, '{1} ya usa su dispositivo {0}'],
  [/^its module (\S+) is used already, by (\S+)$/, '{1} ya usa su módulo {0}'],
  [/^(\S+) lives in this flow already$/, '{0} ya está en este flujo'],
  [/^(\S+) takes (.+), (\S+) takes (.+)$/, '{0} y {2} no admiten el mismo objetivo'],
  [/^(.+) does not use (\S+)$/, '{0} no usa {1}'],
  [
    /^(.+) have one module, (\S+): they cannot live in one flow$/,
    '{0} usan el mismo módulo, {1}: no pueden estar en un mismo flujo',
  ],
  [
    /^(.+) both claim (\S+): they cannot live in one flow$/,
    '{0} usan el mismo dispositivo, {1}: no pueden estar en un mismo flujo',
  ],
  [/^(.+) cannot live in one flow: both give (.+)$/, '{0} no pueden estar en un mismo flujo: ambas dan {1}'],
  [
    /^expected (\S+) as a vector of length 1, found length (.+)$/,
    'se esperaba {0} como vector de longitud 1; tiene {1}',
  ],
  [/^'(\S+)' and '(\S+)' stand at one place$/, '{0} y {1} están en un mismo sitio'],
  [/^there is no task (\S+)$/, 'no hay ninguna tarea {0}'],
  [/^there is no device (.+); (\S+) has (.+)$/, 'no hay ningún dispositivo {0}; {1} tiene {2}'],
  [/^there is no world for the device (\S+), but (.+)$/, 'no hay ningún mundo para el dispositivo {0}; hay {1}'],
  [/^(\S+) is not the device that (\S+) means: (.+)$/, '{0} no es el dispositivo que {1} espera: {2}'],
  [
    /^'(\S+)' is (kinematic), '(\S+)' is (physical); all arms of a world are of one mode$/,
    '{0} es cinemático y {2} es físico; todos los brazos de un mundo son del mismo modo',
  ],
  [
    /^'(\S+)' is (physical), '(\S+)' is (kinematic); all arms of a world are of one mode$/,
    '{0} es físico y {2} es cinemático; todos los brazos de un mundo son del mismo modo',
  ],
  [/^(\S+) and another task both claim (\S+)$/, '{0} y otra tarea usan el mismo dispositivo {1}'],
  [
    /^the name (\S+) stands twice on the search path; that of (.+) is used$/,
    'el nombre {0} está dos veces en la ruta de búsqueda; se usa el de {1}',
  ],
  [
    /^nobody writes (\S+), read by (.+); it keeps its last value$/,
    'nadie escribe {0}, que lee {1}; conserva su último valor',
  ],
  [/^no task gives the constant (.+)$/, 'ninguna tarea da la constante {0}'],
  [/^module (\S+) has no port (.+)$/, 'el módulo {0} no tiene ningún puerto {1}'],
  [
    /^its task has no port (.+), which module (\S+) declares$/,
    'a su tarea le falta el puerto {0}, que declara el módulo {1}',
  ],
  [
    /^1 target is re-resolved for (\S+), by the pose that it is for (\S+)$/,
    '1 objetivo se calcula de nuevo para {0}, por la pose que es para {1}',
  ],
  [
    /^(\d+) targets are re-resolved for (\S+), by the poses that they are for (\S+)$/,
    '{0} objetivos se calculan de nuevo para {1}, por las poses que son para {2}',
  ],
  [
    /^(.+) is re-resolved for (\S+), by the pose that it is for (\S+)$/,
    '{0} se calcula de nuevo para {1}, por la pose que es para {2}',
  ],
  [
    /^(\S+): (\S+) is the hand at the (left|right), and the arm that moves is (.+)$/,
    '{0}: {1} no es la mano del brazo que se mueve, {3}',
  ],
  [/^(\S+) cannot stand for (\S+): ([^]+)$/, '{0} no puede estar en lugar de {1}: {=2}'],
  [
    /^(\S+) runs: (.+) is checked when that has ended$/,
    '{0} se está ejecutando: {1} se comprueba cuando haya terminado',
  ],
  [/^(.+) cannot be checked: ([^]+)$/, '{0} no se puede comprobar: {=1}'],
  [/^there is no configuration (.+)$/, 'no hay ninguna configuración {0}'],
  [
    /^run by itself, only flow 0 runs: nothing before it chooses another$/,
    'si se ejecuta por sí sola, solo se ejecuta el flujo 0: nada antes de ella elige otro',
  ],
  [
    /^(.+) is changed here and not saved: what its file says is run$/,
    '{0} tiene cambios sin guardar: se ejecuta lo que dice su archivo',
  ],
  // saltos en los cambios
  [
    /^(\S+): (\S+) stepped by (.+) at a switch, more than (.+) a cycle: blended over (\d+) cycles$/,
    '{0}: {1} saltó {2} en un cambio, más que {3} por ciclo: se repartió en {4} ciclos',
  ],
  [
    /^(\S+): (\S+) stepped by (.+) at a switch, more than (.+) a cycle and too far to blend: refused, the drive holds$/,
    '{0}: {1} habría saltado {2} en un cambio, demasiado para repartirlo a {3} por ciclo: el accionamiento se mantiene',
  ],
  // qué se puede hacer
  [/^What fits here$/, 'Qué encaja aquí'],
  [/^What fits behind it$/, 'Qué encaja detrás'],
  [/^New (.+) target…$/, 'Nuevo objetivo {0}…'],
  [/^Show it$/, 'Mostrarlo'],
  [/^Remove it$/, 'Quitarlo'],
  [/^Remove the loop$/, 'Quitar el bucle'],
  [/^Remove the tag$/, 'Quitar la etiqueta'],
  [/^Insert a branch$/, 'Insertar una bifurcación'],
  [/^Its values…$/, 'Sus valores…'],
  [/^Let (\S+) do it again$/, 'Que lo haga de nuevo {0}'],
  [/^Redirect (\S+) to (\S+)$/, 'Redirigir {0} a {1}'],
  [/^Open (\S+)$/, 'Abrir {0}'],
  [/^Its conditions…$/, 'Sus condiciones…'],
  [/^Mark it anew…$/, 'Marcarlo de nuevo…'],
  [/^Take it from the dictionary anew$/, 'Tomarlo de nuevo del diccionario'],
  [/^Open its configuration$/, 'Abrir su configuración'],
  [/^Save (.+) and run$|^Save and run$/, 'Guardar y ejecutar'],
  [/^Save as…$/, 'Guardar como…'],
  [/^Save and keep$/, 'Guardar los cambios y seguir'],
  [/^Save (.+)$/, 'Guardar {0}'],
  [/^Abort it$/, 'Interrumpirla'],
  [/^Allow motion$/, 'Permitir el movimiento'],
  [/^Start the runtime anew…$/, 'Iniciar de nuevo el entorno de ejecución…'],
  // cómo va
  [
    /^(.+) runs already, and one application runs at a time$/,
    '{0} ya se está ejecutando, y solo se ejecuta una aplicación a la vez',
  ],
  [/^(\S+) runs$/, '{0} se ejecuta'],
  [/^(.+) is done: 1 action in (.+) s$/, '{0} ha terminado: 1 acción en {1} s'],
  [/^(.+) is done: (\d+) actions in (.+) s$/, '{0} ha terminado: {1} acciones en {2} s'],
  [/^(.+) was aborted after 1 action: ([^]+)$/, '{0} se interrumpió tras 1 acción: {=1}'],
  [/^(.+) was aborted after (\d+) actions: ([^]+)$/, '{0} se interrumpió tras {1} acciones: {=2}'],
  [/^ended by you, after: ([^]+)$/, 'terminada por usted, después de: {=0}'],
  [/^aborted by the user$/, 'interrumpida por el usuario'],
  [/^nothing runs$/, 'nada se está ejecutando'],
  [/^(.+) has nothing to run$/, '{0} no tiene nada que ejecutar'],
  [
    /^The runtime has ended\. Run starts a new one\.$/,
    'El entorno de ejecución ha terminado. Ejecutar inicia uno nuevo.',
  ],
  [/^the runtime is lost: ([^]+)$/, 'se perdió el entorno de ejecución: {=0}'],
  [
    /^a new runtime is there; its workcell is as it was at the beginning$/,
    'hay un entorno de ejecución nuevo; su célula está como al principio',
  ],
  [/^'(.*)' is no name for a file$/, '«{0}» no sirve como nombre de archivo'],
  // grabaciones, simulador y pruebas
  [/^the run cannot be recorded: ([^]+)$/, 'la ejecución no se puede grabar: {=0}'],
  [/^nothing can be written in (.+): (.+)$/, 'no se puede escribir en {0}: {1}'],
  [
    /^(.+) has room for (\d+) MB, and (\d+) MB are wanted at least$/,
    'en {0} quedan {1} MB, y hacen falta al menos {2} MB',
  ],
  [
    /^the runtime at (.+) was started by somebody else: it records runs only for the program that launched it$/,
    'el entorno de ejecución en {0} lo inició otra persona: solo graba para el programa que lo inició',
  ],
  [/^Run without recording$/, 'Ejecutar sin grabar'],
  [
    /^(\d+) values of variables were written over before they could be recorded$/,
    '{0} valores de variables se sobrescribieron antes de poder grabarlos',
  ],
  [
    /^(.+) is repeated in the simulator up to (.+) s and goes on from there$/,
    '{0} se repite en el simulador hasta {1} s y sigue desde ahí',
  ],
  [/^(.+) is repeated in the simulator from its beginning$/, '{0} se repite en el simulador desde el principio'],
  [
    /^the (?:runtime|simulator) that lives now ends for the simulator of this run, and (.+) with (?:its|their) tasks$/,
    'lo que vive ahora termina para dejar sitio al simulador de esta ejecución, y con ello {0} con sus tareas',
  ],
  [
    /^the runtime at (.+) is left for the simulator, and (.+) with it: what this environment held there comes to rest$/,
    'se deja el entorno de ejecución en {0} por el simulador, y con él {1}: lo que este entorno sostenía allí queda en reposo',
  ],
  [
    /^a recorded run is being repeated; it can be stopped, or steered when it has come to its instant$/,
    'se está repitiendo una ejecución grabada; se puede parar, o dirigir cuando llegue a su instante',
  ],
  [/^the recorded run was ended by hand; here it is not$/, 'la ejecución grabada se terminó a mano; aquí no'],
  [
    /^the recording was cut short: it is repeated up to (.+) s, and from there [^]+$/,
    'la grabación quedó cortada: se repite hasta {0} s y desde ahí la ejecución sigue por sí misma, sin lo que se le pidió después',
  ],
  [
    /^approximate: this run was recorded in wall time; [^]+$/,
    'aproximada: se grabó en tiempo real; el mismo plan con las mismas entradas se repite en tiempo virtual desde el principio, de modo que se le acerca y no coincide',
  ],
  [/^End it and go on in the simulator$/, 'Terminarlo y seguir en el simulador'],
  [
    /^(.+) is no longer connected: the simulator has taken the place of its runtime$/,
    '{0} ya no está conectada: el simulador ocupa el lugar de su entorno de ejecución',
  ],
  [/^(.+) is kept: ([^]+)$/, '{0} queda guardada: {=1}'],
  [/^(.+) is not kept: ([^]+)$/, '{0} no se guardó: {=1}'],
  [/^1 actions?, (\d+) values?$/, '1 acción, {0} valores'],
  [/^(\d+) actions, (\d+) values?$/, '{0} acciones, {1} valores'],
  [/^(.+) is there already$/, '{0} ya existe'],
  [/^Replace it$/, 'Reemplazarla'],
  [
    /^(.+) (?:is|are) changed here and not saved; a test does what files say$/,
    '{0} tiene cambios sin guardar; una prueba hace lo que dicen los archivos',
  ],
  [
    /^expected an address, a comparison and a number, as in 'LAMP == 1', found (.+)$/,
    'se esperaba una dirección, una comparación y un número, como en «LAMP == 1», y se encontró {0}',
  ],
  [
    /^only a good run can be kept; in this one (.+) does not hold$/,
    'solo se guarda una ejecución buena; en esta no se cumple {0}',
  ],
  [
    /^only a run that comes to its end can be kept; this one: ([^]+)$/,
    'solo se guarda una ejecución que llega a su fin; esta: {=0}',
  ],
  ...esHeardReview,
  ...esHeardHolding,
  ...esHeardEdit,
  ...esHeardDone,
]
