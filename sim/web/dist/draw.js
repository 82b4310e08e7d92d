"use strict";
(() => {
  // ../../node_modules/linkedom/worker.js
  var CHANGED = /* @__PURE__ */ Symbol("changed");
  var CLASS_LIST = /* @__PURE__ */ Symbol("classList");
  var CUSTOM_ELEMENTS = /* @__PURE__ */ Symbol("CustomElements");
  var CONTENT = /* @__PURE__ */ Symbol("content");
  var DATASET = /* @__PURE__ */ Symbol("dataset");
  var DOCTYPE = /* @__PURE__ */ Symbol("doctype");
  var DOM_PARSER = /* @__PURE__ */ Symbol("DOMParser");
  var END = /* @__PURE__ */ Symbol("end");
  var EVENT_TARGET = /* @__PURE__ */ Symbol("EventTarget");
  var GLOBALS = /* @__PURE__ */ Symbol("globals");
  var IMAGE = /* @__PURE__ */ Symbol("image");
  var MIME = /* @__PURE__ */ Symbol("mime");
  var MUTATION_OBSERVER = /* @__PURE__ */ Symbol("MutationObserver");
  var NEXT = /* @__PURE__ */ Symbol("next");
  var OWNER_ELEMENT = /* @__PURE__ */ Symbol("ownerElement");
  var PREV = /* @__PURE__ */ Symbol("prev");
  var PRIVATE = /* @__PURE__ */ Symbol("private");
  var SHEET = /* @__PURE__ */ Symbol("sheet");
  var START = /* @__PURE__ */ Symbol("start");
  var STYLE = /* @__PURE__ */ Symbol("style");
  var UPGRADE = /* @__PURE__ */ Symbol("upgrade");
  var VALUE = /* @__PURE__ */ Symbol("value");
  var htmlDecodeTree = /* @__PURE__ */ new Uint16Array(
    // prettier-ignore
    /* @__PURE__ */ 'ᵁ<Õıʊҝջאٵ۞ޢߖࠏ੊ઑඡ๭༉༦჊ረዡᐕᒝᓃᓟᔥ\0\0\0\0\0\0ᕫᛍᦍᰒᷝ὾⁠↰⊍⏀⏻⑂⠤⤒ⴈ⹈⿎〖㊺㘹㞬㣾㨨㩱㫠㬮ࠀEMabcfglmnoprstu\\bfms¦³¹ÈÏlig耻Æ䃆P耻&䀦cute耻Á䃁reve;䄂Āiyx}rc耻Â䃂;䐐r;쀀𝔄rave耻À䃀pha;䎑acr;䄀d;橓Āgp¡on;䄄f;쀀𝔸plyFunction;恡ing耻Å䃅Ācs¾Ãr;쀀𝒜ign;扔ilde耻Ã䃃ml耻Ä䃄ЀaceforsuåûþėĜĢħĪĀcrêòkslash;或Ŷöø;櫧ed;挆y;䐑ƀcrtąċĔause;戵noullis;愬a;䎒r;쀀𝔅pf;쀀𝔹eve;䋘còēmpeq;扎܀HOacdefhilorsuōőŖƀƞƢƵƷƺǜȕɳɸɾcy;䐧PY耻©䂩ƀcpyŝŢźute;䄆Ā;iŧŨ拒talDifferentialD;慅leys;愭ȀaeioƉƎƔƘron;䄌dil耻Ç䃇rc;䄈nint;戰ot;䄊ĀdnƧƭilla;䂸terDot;䂷òſi;䎧rcleȀDMPTǇǋǑǖot;抙inus;抖lus;投imes;抗oĀcsǢǸkwiseContourIntegral;戲eCurlyĀDQȃȏoubleQuote;思uote;怙ȀlnpuȞȨɇɕonĀ;eȥȦ户;橴ƀgitȯȶȺruent;扡nt;戯ourIntegral;戮ĀfrɌɎ;愂oduct;成nterClockwiseContourIntegral;戳oss;樯cr;쀀𝒞pĀ;Cʄʅ拓ap;才րDJSZacefiosʠʬʰʴʸˋ˗ˡ˦̳ҍĀ;oŹʥtrahd;椑cy;䐂cy;䐅cy;䐏ƀgrsʿ˄ˇger;怡r;憡hv;櫤Āayː˕ron;䄎;䐔lĀ;t˝˞戇a;䎔r;쀀𝔇Āaf˫̧Ācm˰̢riticalȀADGT̖̜̀̆cute;䂴oŴ̋̍;䋙bleAcute;䋝rave;䁠ilde;䋜ond;拄ferentialD;慆Ѱ̽\0\0\0͔͂\0Ѕf;쀀𝔻ƀ;DE͈͉͍䂨ot;惜qual;扐blèCDLRUVͣͲ΂ϏϢϸontourIntegraìȹoɴ͹\0\0ͻ»͉nArrow;懓Āeo·ΤftƀARTΐΖΡrrow;懐ightArrow;懔eåˊngĀLRΫτeftĀARγιrrow;柸ightArrow;柺ightArrow;柹ightĀATϘϞrrow;懒ee;抨pɁϩ\0\0ϯrrow;懑ownArrow;懕erticalBar;戥ǹABLRTaВЪаўѿͼrrowƀ;BUНОТ憓ar;椓pArrow;懵reve;䌑eft˒к\0ц\0ѐightVector;楐eeVector;楞ectorĀ;Bљњ憽ar;楖ightǔѧ\0ѱeeVector;楟ectorĀ;BѺѻ懁ar;楗eeĀ;A҆҇护rrow;憧ĀctҒҗr;쀀𝒟rok;䄐ࠀNTacdfglmopqstuxҽӀӄӋӞӢӧӮӵԡԯԶՒ՝ՠեG;䅊H耻Ð䃐cute耻É䃉ƀaiyӒӗӜron;䄚rc耻Ê䃊;䐭ot;䄖r;쀀𝔈rave耻È䃈ement;戈ĀapӺӾcr;䄒tyɓԆ\0\0ԒmallSquare;旻erySmallSquare;斫ĀgpԦԪon;䄘f;쀀𝔼silon;䎕uĀaiԼՉlĀ;TՂՃ橵ilde;扂librium;懌Āci՗՚r;愰m;橳a;䎗ml耻Ë䃋Āipժկsts;戃onentialE;慇ʀcfiosօֈ֍ֲ׌y;䐤r;쀀𝔉lledɓ֗\0\0֣mallSquare;旼erySmallSquare;斪Ͱֺ\0ֿ\0\0ׄf;쀀𝔽All;戀riertrf;愱cò׋؀JTabcdfgorstר׬ׯ׺؀ؒؖ؛؝أ٬ٲcy;䐃耻>䀾mmaĀ;d׷׸䎓;䏜reve;䄞ƀeiy؇،ؐdil;䄢rc;䄜;䐓ot;䄠r;쀀𝔊;拙pf;쀀𝔾eater̀EFGLSTصلَٖٛ٦qualĀ;Lؾؿ扥ess;招ullEqual;执reater;檢ess;扷lantEqual;橾ilde;扳cr;쀀𝒢;扫ЀAacfiosuڅڋږڛڞڪھۊRDcy;䐪Āctڐڔek;䋇;䁞irc;䄤r;愌lbertSpace;愋ǰگ\0ڲf;愍izontalLine;攀Āctۃۅòکrok;䄦mpńېۘownHumðįqual;扏܀EJOacdfgmnostuۺ۾܃܇܎ܚܞܡܨ݄ݸދޏޕcy;䐕lig;䄲cy;䐁cute耻Í䃍Āiyܓܘrc耻Î䃎;䐘ot;䄰r;愑rave耻Ì䃌ƀ;apܠܯܿĀcgܴܷr;䄪inaryI;慈lieóϝǴ݉\0ݢĀ;eݍݎ戬Āgrݓݘral;戫section;拂isibleĀCTݬݲomma;恣imes;恢ƀgptݿރވon;䄮f;쀀𝕀a;䎙cr;愐ilde;䄨ǫޚ\0ޞcy;䐆l耻Ï䃏ʀcfosuެ޷޼߂ߐĀiyޱ޵rc;䄴;䐙r;쀀𝔍pf;쀀𝕁ǣ߇\0ߌr;쀀𝒥rcy;䐈kcy;䐄΀HJacfosߤߨ߽߬߱ࠂࠈcy;䐥cy;䐌ppa;䎚Āey߶߻dil;䄶;䐚r;쀀𝔎pf;쀀𝕂cr;쀀𝒦րJTaceflmostࠥࠩࠬࡐࡣ঳সে্਷ੇcy;䐉耻<䀼ʀcmnpr࠷࠼ࡁࡄࡍute;䄹bda;䎛g;柪lacetrf;愒r;憞ƀaeyࡗ࡜ࡡron;䄽dil;䄻;䐛Āfsࡨ॰tԀACDFRTUVarࡾࢩࢱࣦ࣠ࣼयज़ΐ४Ānrࢃ࢏gleBracket;柨rowƀ;BR࢙࢚࢞憐ar;懤ightArrow;懆eiling;挈oǵࢷ\0ࣃbleBracket;柦nǔࣈ\0࣒eeVector;楡ectorĀ;Bࣛࣜ懃ar;楙loor;挊ightĀAV࣯ࣵrrow;憔ector;楎Āerँगeƀ;AVउऊऐ抣rrow;憤ector;楚iangleƀ;BEतथऩ抲ar;槏qual;抴pƀDTVषूौownVector;楑eeVector;楠ectorĀ;Bॖॗ憿ar;楘ectorĀ;B॥०憼ar;楒ightáΜs̀EFGLSTॾঋকঝঢভqualGreater;拚ullEqual;扦reater;扶ess;檡lantEqual;橽ilde;扲r;쀀𝔏Ā;eঽা拘ftarrow;懚idot;䄿ƀnpw৔ਖਛgȀLRlr৞৷ਂਐeftĀAR০৬rrow;柵ightArrow;柷ightArrow;柶eftĀarγਊightáοightáϊf;쀀𝕃erĀLRਢਬeftArrow;憙ightArrow;憘ƀchtਾੀੂòࡌ;憰rok;䅁;扪Ѐacefiosuਗ਼੝੠੷੼અઋ઎p;椅y;䐜Ādl੥੯iumSpace;恟lintrf;愳r;쀀𝔐nusPlus;戓pf;쀀𝕄cò੶;䎜ҀJacefostuણધભીଔଙඑ඗ඞcy;䐊cute;䅃ƀaey઴હાron;䅇dil;䅅;䐝ƀgswે૰଎ativeƀMTV૓૟૨ediumSpace;怋hiĀcn૦૘ë૙eryThiî૙tedĀGL૸ଆreaterGreateòٳessLesóੈLine;䀊r;쀀𝔑ȀBnptଢନଷ଺reak;恠BreakingSpace;䂠f;愕ڀ;CDEGHLNPRSTV୕ୖ୪୼஡௫ఄ౞಄ದ೘ൡඅ櫬Āou୛୤ngruent;扢pCap;扭oubleVerticalBar;戦ƀlqxஃஊ஛ement;戉ualĀ;Tஒஓ扠ilde;쀀≂̸ists;戄reater΀;EFGLSTஶஷ஽௉௓௘௥扯qual;扱ullEqual;쀀≧̸reater;쀀≫̸ess;批lantEqual;쀀⩾̸ilde;扵umpń௲௽ownHump;쀀≎̸qual;쀀≏̸eĀfsఊధtTriangleƀ;BEచఛడ拪ar;쀀⧏̸qual;括s̀;EGLSTవశ఼ౄోౘ扮qual;扰reater;扸ess;쀀≪̸lantEqual;쀀⩽̸ilde;扴estedĀGL౨౹reaterGreater;쀀⪢̸essLess;쀀⪡̸recedesƀ;ESಒಓಛ技qual;쀀⪯̸lantEqual;拠ĀeiಫಹverseElement;戌ghtTriangleƀ;BEೋೌ೒拫ar;쀀⧐̸qual;拭ĀquೝഌuareSuĀbp೨೹setĀ;E೰ೳ쀀⊏̸qual;拢ersetĀ;Eഃആ쀀⊐̸qual;拣ƀbcpഓതൎsetĀ;Eഛഞ쀀⊂⃒qual;抈ceedsȀ;ESTലള഻െ抁qual;쀀⪰̸lantEqual;拡ilde;쀀≿̸ersetĀ;E൘൛쀀⊃⃒qual;抉ildeȀ;EFT൮൯൵ൿ扁qual;扄ullEqual;扇ilde;扉erticalBar;戤cr;쀀𝒩ilde耻Ñ䃑;䎝܀Eacdfgmoprstuvලෂ෉෕ෛ෠෧෼ขภยา฿ไlig;䅒cute耻Ó䃓Āiy෎ීrc耻Ô䃔;䐞blac;䅐r;쀀𝔒rave耻Ò䃒ƀaei෮ෲ෶cr;䅌ga;䎩cron;䎟pf;쀀𝕆enCurlyĀDQฎบoubleQuote;怜uote;怘;橔Āclวฬr;쀀𝒪ash耻Ø䃘iŬื฼de耻Õ䃕es;樷ml耻Ö䃖erĀBP๋๠Āar๐๓r;怾acĀek๚๜;揞et;掴arenthesis;揜Ҁacfhilors๿ງຊຏຒດຝະ໼rtialD;戂y;䐟r;쀀𝔓i;䎦;䎠usMinus;䂱Āipຢອncareplanåڝf;愙Ȁ;eio຺ູ໠໤檻cedesȀ;EST່້໏໚扺qual;檯lantEqual;扼ilde;找me;怳Ādp໩໮uct;戏ortionĀ;aȥ໹l;戝Āci༁༆r;쀀𝒫;䎨ȀUfos༑༖༛༟OT耻"䀢r;쀀𝔔pf;愚cr;쀀𝒬؀BEacefhiorsu༾གྷཇའཱིྦྷྪྭ႖ႩႴႾarr;椐G耻®䂮ƀcnrཎནབute;䅔g;柫rĀ;tཛྷཝ憠l;椖ƀaeyཧཬཱron;䅘dil;䅖;䐠Ā;vླྀཹ愜erseĀEUྂྙĀlq྇ྎement;戋uilibrium;懋pEquilibrium;楯r»ཹo;䎡ghtЀACDFTUVa࿁࿫࿳ဢဨၛႇϘĀnr࿆࿒gleBracket;柩rowƀ;BL࿜࿝࿡憒ar;懥eftArrow;懄eiling;按oǵ࿹\0စbleBracket;柧nǔည\0နeeVector;楝ectorĀ;Bဝသ懂ar;楕loor;挋Āerိ၃eƀ;AVဵံြ抢rrow;憦ector;楛iangleƀ;BEၐၑၕ抳ar;槐qual;抵pƀDTVၣၮၸownVector;楏eeVector;楜ectorĀ;Bႂႃ憾ar;楔ectorĀ;B႑႒懀ar;楓Āpuႛ႞f;愝ndImplies;楰ightarrow;懛ĀchႹႼr;愛;憱leDelayed;槴ڀHOacfhimoqstuფჱჷჽᄙᄞᅑᅖᅡᅧᆵᆻᆿĀCcჩხHcy;䐩y;䐨FTcy;䐬cute;䅚ʀ;aeiyᄈᄉᄎᄓᄗ檼ron;䅠dil;䅞rc;䅜;䐡r;쀀𝔖ortȀDLRUᄪᄴᄾᅉownArrow»ОeftArrow»࢚ightArrow»࿝pArrow;憑gma;䎣allCircle;战pf;쀀𝕊ɲᅭ\0\0ᅰt;戚areȀ;ISUᅻᅼᆉᆯ斡ntersection;抓uĀbpᆏᆞsetĀ;Eᆗᆘ抏qual;抑ersetĀ;Eᆨᆩ抐qual;抒nion;抔cr;쀀𝒮ar;拆ȀbcmpᇈᇛሉላĀ;sᇍᇎ拐etĀ;Eᇍᇕqual;抆ĀchᇠህeedsȀ;ESTᇭᇮᇴᇿ扻qual;檰lantEqual;扽ilde;承Tháྌ;我ƀ;esሒሓሣ拑rsetĀ;Eሜም抃qual;抇et»ሓրHRSacfhiorsሾቄ቉ቕ቞ቱቶኟዂወዑORN耻Þ䃞ADE;愢ĀHc቎ቒcy;䐋y;䐦Ābuቚቜ;䀉;䎤ƀaeyብቪቯron;䅤dil;䅢;䐢r;쀀𝔗Āeiቻ኉ǲኀ\0ኇefore;戴a;䎘Ācn኎ኘkSpace;쀀  Space;怉ldeȀ;EFTካኬኲኼ戼qual;扃ullEqual;扅ilde;扈pf;쀀𝕋ipleDot;惛Āctዖዛr;쀀𝒯rok;䅦ૡዷጎጚጦ\0ጬጱ\0\0\0\0\0ጸጽ፷ᎅ\0᏿ᐄᐊᐐĀcrዻጁute耻Ú䃚rĀ;oጇገ憟cir;楉rǣጓ\0጖y;䐎ve;䅬Āiyጞጣrc耻Û䃛;䐣blac;䅰r;쀀𝔘rave耻Ù䃙acr;䅪Ādiፁ፩erĀBPፈ፝Āarፍፐr;䁟acĀekፗፙ;揟et;掵arenthesis;揝onĀ;P፰፱拃lus;抎Āgp፻፿on;䅲f;쀀𝕌ЀADETadps᎕ᎮᎸᏄϨᏒᏗᏳrrowƀ;BDᅐᎠᎤar;椒ownArrow;懅ownArrow;憕quilibrium;楮eeĀ;AᏋᏌ报rrow;憥ownáϳerĀLRᏞᏨeftArrow;憖ightArrow;憗iĀ;lᏹᏺ䏒on;䎥ing;䅮cr;쀀𝒰ilde;䅨ml耻Ü䃜ҀDbcdefosvᐧᐬᐰᐳᐾᒅᒊᒐᒖash;披ar;櫫y;䐒ashĀ;lᐻᐼ抩;櫦Āerᑃᑅ;拁ƀbtyᑌᑐᑺar;怖Ā;iᑏᑕcalȀBLSTᑡᑥᑪᑴar;戣ine;䁼eparator;杘ilde;所ThinSpace;怊r;쀀𝔙pf;쀀𝕍cr;쀀𝒱dash;抪ʀcefosᒧᒬᒱᒶᒼirc;䅴dge;拀r;쀀𝔚pf;쀀𝕎cr;쀀𝒲Ȁfiosᓋᓐᓒᓘr;쀀𝔛;䎞pf;쀀𝕏cr;쀀𝒳ҀAIUacfosuᓱᓵᓹᓽᔄᔏᔔᔚᔠcy;䐯cy;䐇cy;䐮cute耻Ý䃝Āiyᔉᔍrc;䅶;䐫r;쀀𝔜pf;쀀𝕐cr;쀀𝒴ml;䅸ЀHacdefosᔵᔹᔿᕋᕏᕝᕠᕤcy;䐖cute;䅹Āayᕄᕉron;䅽;䐗ot;䅻ǲᕔ\0ᕛoWidtè૙a;䎖r;愨pf;愤cr;쀀𝒵௡ᖃᖊᖐ\0ᖰᖶᖿ\0\0\0\0ᗆᗛᗫᙟ᙭\0ᚕ᚛ᚲᚹ\0ᚾcute耻á䃡reve;䄃̀;Ediuyᖜᖝᖡᖣᖨᖭ戾;쀀∾̳;房rc耻â䃢te肻´̆;䐰lig耻æ䃦Ā;r²ᖺ;쀀𝔞rave耻à䃠ĀepᗊᗖĀfpᗏᗔsym;愵èᗓha;䎱ĀapᗟcĀclᗤᗧr;䄁g;樿ɤᗰ\0\0ᘊʀ;adsvᗺᗻᗿᘁᘇ戧nd;橕;橜lope;橘;橚΀;elmrszᘘᘙᘛᘞᘿᙏᙙ戠;榤e»ᘙsdĀ;aᘥᘦ戡ѡᘰᘲᘴᘶᘸᘺᘼᘾ;榨;榩;榪;榫;榬;榭;榮;榯tĀ;vᙅᙆ戟bĀ;dᙌᙍ抾;榝Āptᙔᙗh;戢»¹arr;捼Āgpᙣᙧon;䄅f;쀀𝕒΀;Eaeiop዁ᙻᙽᚂᚄᚇᚊ;橰cir;橯;扊d;手s;䀧roxĀ;e዁ᚒñᚃing耻å䃥ƀctyᚡᚦᚨr;쀀𝒶;䀪mpĀ;e዁ᚯñʈilde耻ã䃣ml耻ä䃤Āciᛂᛈoninôɲnt;樑ࠀNabcdefiklnoprsu᛭ᛱᜰ᜼ᝃᝈ᝸᝽០៦ᠹᡐᜍ᤽᥈ᥰot;櫭Ācrᛶ᜞kȀcepsᜀᜅᜍᜓong;扌psilon;䏶rime;怵imĀ;e᜚᜛戽q;拍Ŷᜢᜦee;抽edĀ;gᜬᜭ挅e»ᜭrkĀ;t፜᜷brk;掶Āoyᜁᝁ;䐱quo;怞ʀcmprtᝓ᝛ᝡᝤᝨausĀ;eĊĉptyv;榰séᜌnoõēƀahwᝯ᝱ᝳ;䎲;愶een;扬r;쀀𝔟g΀costuvwឍឝឳេ៕៛៞ƀaiuបពរðݠrc;旯p»፱ƀdptឤឨឭot;樀lus;樁imes;樂ɱឹ\0\0ើcup;樆ar;昅riangleĀdu៍្own;施p;斳plus;樄eåᑄåᒭarow;植ƀako៭ᠦᠵĀcn៲ᠣkƀlst៺֫᠂ozenge;槫riangleȀ;dlr᠒᠓᠘᠝斴own;斾eft;旂ight;斸k;搣Ʊᠫ\0ᠳƲᠯ\0ᠱ;斒;斑4;斓ck;斈ĀeoᠾᡍĀ;qᡃᡆ쀀=⃥uiv;쀀≡⃥t;挐Ȁptwxᡙᡞᡧᡬf;쀀𝕓Ā;tᏋᡣom»Ꮜtie;拈؀DHUVbdhmptuvᢅᢖᢪᢻᣗᣛᣬ᣿ᤅᤊᤐᤡȀLRlrᢎᢐᢒᢔ;敗;敔;敖;敓ʀ;DUduᢡᢢᢤᢦᢨ敐;敦;敩;敤;敧ȀLRlrᢳᢵᢷᢹ;敝;敚;敜;教΀;HLRhlrᣊᣋᣍᣏᣑᣓᣕ救;敬;散;敠;敫;敢;敟ox;槉ȀLRlrᣤᣦᣨᣪ;敕;敒;攐;攌ʀ;DUduڽ᣷᣹᣻᣽;敥;敨;攬;攴inus;抟lus;択imes;抠ȀLRlrᤙᤛᤝ᤟;敛;敘;攘;攔΀;HLRhlrᤰᤱᤳᤵᤷ᤻᤹攂;敪;敡;敞;攼;攤;攜Āevģ᥂bar耻¦䂦Ȁceioᥑᥖᥚᥠr;쀀𝒷mi;恏mĀ;e᜚᜜lƀ;bhᥨᥩᥫ䁜;槅sub;柈Ŭᥴ᥾lĀ;e᥹᥺怢t»᥺pƀ;Eeįᦅᦇ;檮Ā;qۜۛೡᦧ\0᧨ᨑᨕᨲ\0ᨷᩐ\0\0᪴\0\0᫁\0\0ᬡᬮ᭍᭒\0᯽\0ᰌƀcpr᦭ᦲ᧝ute;䄇̀;abcdsᦿᧀᧄ᧊᧕᧙戩nd;橄rcup;橉Āau᧏᧒p;橋p;橇ot;橀;쀀∩︀Āeo᧢᧥t;恁îړȀaeiu᧰᧻ᨁᨅǰ᧵\0᧸s;橍on;䄍dil耻ç䃧rc;䄉psĀ;sᨌᨍ橌m;橐ot;䄋ƀdmnᨛᨠᨦil肻¸ƭptyv;榲t脀¢;eᨭᨮ䂢räƲr;쀀𝔠ƀceiᨽᩀᩍy;䑇ckĀ;mᩇᩈ朓ark»ᩈ;䏇r΀;Ecefms᩟᩠ᩢᩫ᪤᪪᪮旋;槃ƀ;elᩩᩪᩭ䋆q;扗eɡᩴ\0\0᪈rrowĀlr᩼᪁eft;憺ight;憻ʀRSacd᪒᪔᪖᪚᪟»ཇ;擈st;抛irc;抚ash;抝nint;樐id;櫯cir;槂ubsĀ;u᪻᪼晣it»᪼ˬ᫇᫔᫺\0ᬊonĀ;eᫍᫎ䀺Ā;qÇÆɭ᫙\0\0᫢aĀ;t᫞᫟䀬;䁀ƀ;fl᫨᫩᫫戁îᅠeĀmx᫱᫶ent»᫩eóɍǧ᫾\0ᬇĀ;dኻᬂot;橭nôɆƀfryᬐᬔᬗ;쀀𝕔oäɔ脀©;sŕᬝr;愗Āaoᬥᬩrr;憵ss;朗Ācuᬲᬷr;쀀𝒸Ābpᬼ᭄Ā;eᭁᭂ櫏;櫑Ā;eᭉᭊ櫐;櫒dot;拯΀delprvw᭠᭬᭷ᮂᮬᯔ᯹arrĀlr᭨᭪;椸;椵ɰ᭲\0\0᭵r;拞c;拟arrĀ;p᭿ᮀ憶;椽̀;bcdosᮏᮐᮖᮡᮥᮨ截rcap;橈Āauᮛᮞp;橆p;橊ot;抍r;橅;쀀∪︀Ȁalrv᮵ᮿᯞᯣrrĀ;mᮼᮽ憷;椼yƀevwᯇᯔᯘqɰᯎ\0\0ᯒreã᭳uã᭵ee;拎edge;拏en耻¤䂤earrowĀlrᯮ᯳eft»ᮀight»ᮽeäᯝĀciᰁᰇoninôǷnt;戱lcty;挭ঀAHabcdefhijlorstuwz᰸᰻᰿ᱝᱩᱵᲊᲞᲬᲷ᳻᳿ᴍᵻᶑᶫᶻ᷆᷍rò΁ar;楥Ȁglrs᱈ᱍ᱒᱔ger;怠eth;愸òᄳhĀ;vᱚᱛ怐»ऊūᱡᱧarow;椏aã̕Āayᱮᱳron;䄏;䐴ƀ;ao̲ᱼᲄĀgrʿᲁr;懊tseq;橷ƀglmᲑᲔᲘ耻°䂰ta;䎴ptyv;榱ĀirᲣᲨsht;楿;쀀𝔡arĀlrᲳᲵ»ࣜ»သʀaegsv᳂͸᳖᳜᳠mƀ;oș᳊᳔ndĀ;ș᳑uit;晦amma;䏝in;拲ƀ;io᳧᳨᳸䃷de脀÷;o᳧ᳰntimes;拇nø᳷cy;䑒cɯᴆ\0\0ᴊrn;挞op;挍ʀlptuwᴘᴝᴢᵉᵕlar;䀤f;쀀𝕕ʀ;emps̋ᴭᴷᴽᵂqĀ;d͒ᴳot;扑inus;戸lus;戔quare;抡blebarwedgåúnƀadhᄮᵝᵧownarrowóᲃarpoonĀlrᵲᵶefôᲴighôᲶŢᵿᶅkaro÷གɯᶊ\0\0ᶎrn;挟op;挌ƀcotᶘᶣᶦĀryᶝᶡ;쀀𝒹;䑕l;槶rok;䄑Ādrᶰᶴot;拱iĀ;fᶺ᠖斿Āah᷀᷃ròЩaòྦangle;榦Āci᷒ᷕy;䑟grarr;柿ऀDacdefglmnopqrstuxḁḉḙḸոḼṉṡṾấắẽỡἪἷὄ὎὚ĀDoḆᴴoôᲉĀcsḎḔute耻é䃩ter;橮ȀaioyḢḧḱḶron;䄛rĀ;cḭḮ扖耻ê䃪lon;払;䑍ot;䄗ĀDrṁṅot;扒;쀀𝔢ƀ;rsṐṑṗ檚ave耻è䃨Ā;dṜṝ檖ot;檘Ȁ;ilsṪṫṲṴ檙nters;揧;愓Ā;dṹṺ檕ot;檗ƀapsẅẉẗcr;䄓tyƀ;svẒẓẕ戅et»ẓpĀ1;ẝẤĳạả;怄;怅怃ĀgsẪẬ;䅋p;怂ĀgpẴẸon;䄙f;쀀𝕖ƀalsỄỎỒrĀ;sỊị拕l;槣us;橱iƀ;lvỚớở䎵on»ớ;䏵ȀcsuvỪỳἋἣĀioữḱrc»Ḯɩỹ\0\0ỻíՈantĀglἂἆtr»ṝess»Ṻƀaeiἒ἖Ἒls;䀽st;扟vĀ;DȵἠD;橸parsl;槥ĀDaἯἳot;打rr;楱ƀcdiἾὁỸr;愯oô͒ĀahὉὋ;䎷耻ð䃰Āmrὓὗl耻ë䃫o;悬ƀcipὡὤὧl;䀡sôծĀeoὬὴctatioîՙnentialåչৡᾒ\0ᾞ\0ᾡᾧ\0\0ῆῌ\0ΐ\0ῦῪ \0 ⁚llingdotseñṄy;䑄male;晀ƀilrᾭᾳ῁lig;耀ﬃɩᾹ\0\0᾽g;耀ﬀig;耀ﬄ;쀀𝔣lig;耀ﬁlig;쀀fjƀaltῙ῜ῡt;晭ig;耀ﬂns;斱of;䆒ǰ΅\0ῳf;쀀𝕗ĀakֿῷĀ;vῼ´拔;櫙artint;樍Āao‌⁕Ācs‑⁒α‚‰‸⁅⁈\0⁐β•‥‧‪‬\0‮耻½䂽;慓耻¼䂼;慕;慙;慛Ƴ‴\0‶;慔;慖ʴ‾⁁\0\0⁃耻¾䂾;慗;慜5;慘ƶ⁌\0⁎;慚;慝8;慞l;恄wn;挢cr;쀀𝒻ࢀEabcdefgijlnorstv₂₉₟₥₰₴⃰⃵⃺⃿℃ℒℸ̗ℾ⅒↞Ā;lٍ₇;檌ƀcmpₐₕ₝ute;䇵maĀ;dₜ᳚䎳;檆reve;䄟Āiy₪₮rc;䄝;䐳ot;䄡Ȁ;lqsؾق₽⃉ƀ;qsؾٌ⃄lanô٥Ȁ;cdl٥⃒⃥⃕c;檩otĀ;o⃜⃝檀Ā;l⃢⃣檂;檄Ā;e⃪⃭쀀⋛︀s;檔r;쀀𝔤Ā;gٳ؛mel;愷cy;䑓Ȁ;Eajٚℌℎℐ;檒;檥;檤ȀEaesℛℝ℩ℴ;扩pĀ;p℣ℤ檊rox»ℤĀ;q℮ℯ檈Ā;q℮ℛim;拧pf;쀀𝕘Āci⅃ⅆr;愊mƀ;el٫ⅎ⅐;檎;檐茀>;cdlqr׮ⅠⅪⅮⅳⅹĀciⅥⅧ;檧r;橺ot;拗Par;榕uest;橼ʀadelsↄⅪ←ٖ↛ǰ↉\0↎proø₞r;楸qĀlqؿ↖lesó₈ií٫Āen↣↭rtneqq;쀀≩︀Å↪ԀAabcefkosy⇄⇇⇱⇵⇺∘∝∯≨≽ròΠȀilmr⇐⇔⇗⇛rsðᒄf»․ilôکĀdr⇠⇤cy;䑊ƀ;cwࣴ⇫⇯ir;楈;憭ar;意irc;䄥ƀalr∁∎∓rtsĀ;u∉∊晥it»∊lip;怦con;抹r;쀀𝔥sĀew∣∩arow;椥arow;椦ʀamopr∺∾≃≞≣rr;懿tht;戻kĀlr≉≓eftarrow;憩ightarrow;憪f;쀀𝕙bar;怕ƀclt≯≴≸r;쀀𝒽asè⇴rok;䄧Ābp⊂⊇ull;恃hen»ᱛૡ⊣\0⊪\0⊸⋅⋎\0⋕⋳\0\0⋸⌢⍧⍢⍿\0⎆⎪⎴cute耻í䃭ƀ;iyݱ⊰⊵rc耻î䃮;䐸Ācx⊼⊿y;䐵cl耻¡䂡ĀfrΟ⋉;쀀𝔦rave耻ì䃬Ȁ;inoܾ⋝⋩⋮Āin⋢⋦nt;樌t;戭fin;槜ta;愩lig;䄳ƀaop⋾⌚⌝ƀcgt⌅⌈⌗r;䄫ƀelpܟ⌏⌓inåގarôܠh;䄱f;抷ed;䆵ʀ;cfotӴ⌬⌱⌽⍁are;愅inĀ;t⌸⌹戞ie;槝doô⌙ʀ;celpݗ⍌⍐⍛⍡al;抺Āgr⍕⍙eróᕣã⍍arhk;樗rod;樼Ȁcgpt⍯⍲⍶⍻y;䑑on;䄯f;쀀𝕚a;䎹uest耻¿䂿Āci⎊⎏r;쀀𝒾nʀ;EdsvӴ⎛⎝⎡ӳ;拹ot;拵Ā;v⎦⎧拴;拳Ā;iݷ⎮lde;䄩ǫ⎸\0⎼cy;䑖l耻ï䃯̀cfmosu⏌⏗⏜⏡⏧⏵Āiy⏑⏕rc;䄵;䐹r;쀀𝔧ath;䈷pf;쀀𝕛ǣ⏬\0⏱r;쀀𝒿rcy;䑘kcy;䑔Ѐacfghjos␋␖␢␧␭␱␵␻ppaĀ;v␓␔䎺;䏰Āey␛␠dil;䄷;䐺r;쀀𝔨reen;䄸cy;䑅cy;䑜pf;쀀𝕜cr;쀀𝓀஀ABEHabcdefghjlmnoprstuv⑰⒁⒆⒍⒑┎┽╚▀♎♞♥♹♽⚚⚲⛘❝❨➋⟀⠁⠒ƀart⑷⑺⑼rò৆òΕail;椛arr;椎Ā;gঔ⒋;檋ar;楢ॣ⒥\0⒪\0⒱\0\0\0\0\0⒵Ⓔ\0ⓆⓈⓍ\0⓹ute;䄺mptyv;榴raîࡌbda;䎻gƀ;dlࢎⓁⓃ;榑åࢎ;檅uo耻«䂫rЀ;bfhlpst࢙ⓞⓦⓩ⓫⓮⓱⓵Ā;f࢝ⓣs;椟s;椝ë≒p;憫l;椹im;楳l;憢ƀ;ae⓿─┄檫il;椙Ā;s┉┊檭;쀀⪭︀ƀabr┕┙┝rr;椌rk;杲Āak┢┬cĀek┨┪;䁻;䁛Āes┱┳;榋lĀdu┹┻;榏;榍Ȁaeuy╆╋╖╘ron;䄾Ādi═╔il;䄼ìࢰâ┩;䐻Ȁcqrs╣╦╭╽a;椶uoĀ;rนᝆĀdu╲╷har;楧shar;楋h;憲ʀ;fgqs▋▌উ◳◿扤tʀahlrt▘▤▷◂◨rrowĀ;t࢙□aé⓶arpoonĀdu▯▴own»њp»०eftarrows;懇ightƀahs◍◖◞rrowĀ;sࣴࢧarpoonó྘quigarro÷⇰hreetimes;拋ƀ;qs▋ও◺lanôবʀ;cdgsব☊☍☝☨c;檨otĀ;o☔☕橿Ā;r☚☛檁;檃Ā;e☢☥쀀⋚︀s;檓ʀadegs☳☹☽♉♋pproøⓆot;拖qĀgq♃♅ôউgtò⒌ôছiíলƀilr♕࣡♚sht;楼;쀀𝔩Ā;Eজ♣;檑š♩♶rĀdu▲♮Ā;l॥♳;楪lk;斄cy;䑙ʀ;achtੈ⚈⚋⚑⚖rò◁orneòᴈard;楫ri;旺Āio⚟⚤dot;䅀ustĀ;a⚬⚭掰che»⚭ȀEaes⚻⚽⛉⛔;扨pĀ;p⛃⛄檉rox»⛄Ā;q⛎⛏檇Ā;q⛎⚻im;拦Ѐabnoptwz⛩⛴⛷✚✯❁❇❐Ānr⛮⛱g;柬r;懽rëࣁgƀlmr⛿✍✔eftĀar০✇ightá৲apsto;柼ightá৽parrowĀlr✥✩efô⓭ight;憬ƀafl✶✹✽r;榅;쀀𝕝us;樭imes;樴š❋❏st;戗áፎƀ;ef❗❘᠀旊nge»❘arĀ;l❤❥䀨t;榓ʀachmt❳❶❼➅➇ròࢨorneòᶌarĀ;d྘➃;業;怎ri;抿̀achiqt➘➝ੀ➢➮➻quo;怹r;쀀𝓁mƀ;egল➪➬;檍;檏Ābu┪➳oĀ;rฟ➹;怚rok;䅂萀<;cdhilqrࠫ⟒☹⟜⟠⟥⟪⟰Āci⟗⟙;檦r;橹reå◲mes;拉arr;楶uest;橻ĀPi⟵⟹ar;榖ƀ;ef⠀भ᠛旃rĀdu⠇⠍shar;楊har;楦Āen⠗⠡rtneqq;쀀≨︀Å⠞܀Dacdefhilnopsu⡀⡅⢂⢎⢓⢠⢥⢨⣚⣢⣤ઃ⣳⤂Dot;戺Ȁclpr⡎⡒⡣⡽r耻¯䂯Āet⡗⡙;時Ā;e⡞⡟朠se»⡟Ā;sျ⡨toȀ;dluျ⡳⡷⡻owîҌefôएðᏑker;斮Āoy⢇⢌mma;権;䐼ash;怔asuredangle»ᘦr;쀀𝔪o;愧ƀcdn⢯⢴⣉ro耻µ䂵Ȁ;acdᑤ⢽⣀⣄sôᚧir;櫰ot肻·Ƶusƀ;bd⣒ᤃ⣓戒Ā;uᴼ⣘;横ţ⣞⣡p;櫛ò−ðઁĀdp⣩⣮els;抧f;쀀𝕞Āct⣸⣽r;쀀𝓂pos»ᖝƀ;lm⤉⤊⤍䎼timap;抸ఀGLRVabcdefghijlmoprstuvw⥂⥓⥾⦉⦘⧚⧩⨕⨚⩘⩝⪃⪕⪤⪨⬄⬇⭄⭿⮮ⰴⱧⱼ⳩Āgt⥇⥋;쀀⋙̸Ā;v⥐௏쀀≫⃒ƀelt⥚⥲⥶ftĀar⥡⥧rrow;懍ightarrow;懎;쀀⋘̸Ā;v⥻ే쀀≪⃒ightarrow;懏ĀDd⦎⦓ash;抯ash;抮ʀbcnpt⦣⦧⦬⦱⧌la»˞ute;䅄g;쀀∠⃒ʀ;Eiop඄⦼⧀⧅⧈;쀀⩰̸d;쀀≋̸s;䅉roø඄urĀ;a⧓⧔普lĀ;s⧓ସǳ⧟\0⧣p肻 ଷmpĀ;e௹ఀʀaeouy⧴⧾⨃⨐⨓ǰ⧹\0⧻;橃on;䅈dil;䅆ngĀ;dൾ⨊ot;쀀⩭̸p;橂;䐽ash;怓΀;Aadqsxஒ⨩⨭⨻⩁⩅⩐rr;懗rĀhr⨳⨶k;椤Ā;oᏲᏰot;쀀≐̸uiöୣĀei⩊⩎ar;椨í஘istĀ;s஠டr;쀀𝔫ȀEest௅⩦⩹⩼ƀ;qs஼⩭௡ƀ;qs஼௅⩴lanô௢ií௪Ā;rஶ⪁»ஷƀAap⪊⪍⪑rò⥱rr;憮ar;櫲ƀ;svྍ⪜ྌĀ;d⪡⪢拼;拺cy;䑚΀AEadest⪷⪺⪾⫂⫅⫶⫹rò⥦;쀀≦̸rr;憚r;急Ȁ;fqs఻⫎⫣⫯tĀar⫔⫙rro÷⫁ightarro÷⪐ƀ;qs఻⪺⫪lanôౕĀ;sౕ⫴»శiíౝĀ;rవ⫾iĀ;eచథiäඐĀpt⬌⬑f;쀀𝕟膀¬;in⬙⬚⬶䂬nȀ;Edvஉ⬤⬨⬮;쀀⋹̸ot;쀀⋵̸ǡஉ⬳⬵;拷;拶iĀ;vಸ⬼ǡಸ⭁⭃;拾;拽ƀaor⭋⭣⭩rȀ;ast୻⭕⭚⭟lleì୻l;쀀⫽⃥;쀀∂̸lint;樔ƀ;ceಒ⭰⭳uåಥĀ;cಘ⭸Ā;eಒ⭽ñಘȀAait⮈⮋⮝⮧rò⦈rrƀ;cw⮔⮕⮙憛;쀀⤳̸;쀀↝̸ghtarrow»⮕riĀ;eೋೖ΀chimpqu⮽⯍⯙⬄୸⯤⯯Ȁ;cerല⯆ഷ⯉uå൅;쀀𝓃ortɭ⬅\0\0⯖ará⭖mĀ;e൮⯟Ā;q൴൳suĀbp⯫⯭å೸åഋƀbcp⯶ⰑⰙȀ;Ees⯿ⰀഢⰄ抄;쀀⫅̸etĀ;eഛⰋqĀ;qണⰀcĀ;eലⰗñസȀ;EesⰢⰣൟⰧ抅;쀀⫆̸etĀ;e൘ⰮqĀ;qൠⰣȀgilrⰽⰿⱅⱇìௗlde耻ñ䃱çృiangleĀlrⱒⱜeftĀ;eచⱚñదightĀ;eೋⱥñ೗Ā;mⱬⱭ䎽ƀ;esⱴⱵⱹ䀣ro;愖p;怇ҀDHadgilrsⲏⲔⲙⲞⲣⲰⲶⳓⳣash;抭arr;椄p;쀀≍⃒ash;抬ĀetⲨⲬ;쀀≥⃒;쀀>⃒nfin;槞ƀAetⲽⳁⳅrr;椂;쀀≤⃒Ā;rⳊⳍ쀀<⃒ie;쀀⊴⃒ĀAtⳘⳜrr;椃rie;쀀⊵⃒im;쀀∼⃒ƀAan⳰⳴ⴂrr;懖rĀhr⳺⳽k;椣Ā;oᏧᏥear;椧ቓ᪕\0\0\0\0\0\0\0\0\0\0\0\0\0ⴭ\0ⴸⵈⵠⵥ⵲ⶄᬇ\0\0ⶍⶫ\0ⷈⷎ\0ⷜ⸙⸫⸾⹃Ācsⴱ᪗ute耻ó䃳ĀiyⴼⵅrĀ;c᪞ⵂ耻ô䃴;䐾ʀabios᪠ⵒⵗǈⵚlac;䅑v;樸old;榼lig;䅓Ācr⵩⵭ir;榿;쀀𝔬ͯ⵹\0\0⵼\0ⶂn;䋛ave耻ò䃲;槁Ābmⶈ෴ar;榵Ȁacitⶕ⶘ⶥⶨrò᪀Āir⶝ⶠr;榾oss;榻nå๒;槀ƀaeiⶱⶵⶹcr;䅍ga;䏉ƀcdnⷀⷅǍron;䎿;榶pf;쀀𝕠ƀaelⷔ⷗ǒr;榷rp;榹΀;adiosvⷪⷫⷮ⸈⸍⸐⸖戨rò᪆Ȁ;efmⷷⷸ⸂⸅橝rĀ;oⷾⷿ愴f»ⷿ耻ª䂪耻º䂺gof;抶r;橖lope;橗;橛ƀclo⸟⸡⸧ò⸁ash耻ø䃸l;折iŬⸯ⸴de耻õ䃵esĀ;aǛ⸺s;樶ml耻ö䃶bar;挽ૡ⹞\0⹽\0⺀⺝\0⺢⺹\0\0⻋ຜ\0⼓\0\0⼫⾼\0⿈rȀ;astЃ⹧⹲຅脀¶;l⹭⹮䂶leìЃɩ⹸\0\0⹻m;櫳;櫽y;䐿rʀcimpt⺋⺏⺓ᡥ⺗nt;䀥od;䀮il;怰enk;怱r;쀀𝔭ƀimo⺨⺰⺴Ā;v⺭⺮䏆;䏕maô੶ne;明ƀ;tv⺿⻀⻈䏀chfork»´;䏖Āau⻏⻟nĀck⻕⻝kĀ;h⇴⻛;愎ö⇴sҀ;abcdemst⻳⻴ᤈ⻹⻽⼄⼆⼊⼎䀫cir;樣ir;樢Āouᵀ⼂;樥;橲n肻±ຝim;樦wo;樧ƀipu⼙⼠⼥ntint;樕f;쀀𝕡nd耻£䂣Ԁ;Eaceinosu່⼿⽁⽄⽇⾁⾉⾒⽾⾶;檳p;檷uå໙Ā;c໎⽌̀;acens່⽙⽟⽦⽨⽾pproø⽃urlyeñ໙ñ໎ƀaes⽯⽶⽺pprox;檹qq;檵im;拨iíໟmeĀ;s⾈ຮ怲ƀEas⽸⾐⽺ð⽵ƀdfp໬⾙⾯ƀals⾠⾥⾪lar;挮ine;挒urf;挓Ā;t໻⾴ï໻rel;抰Āci⿀⿅r;쀀𝓅;䏈ncsp;怈̀fiopsu⿚⋢⿟⿥⿫⿱r;쀀𝔮pf;쀀𝕢rime;恗cr;쀀𝓆ƀaeo⿸〉〓tĀei⿾々rnionóڰnt;樖stĀ;e【】䀿ñἙô༔઀ABHabcdefhilmnoprstux぀けさすムㄎㄫㅇㅢㅲㆎ㈆㈕㈤㈩㉘㉮㉲㊐㊰㊷ƀartぇおがròႳòϝail;検aròᱥar;楤΀cdenqrtとふへみわゔヌĀeuねぱ;쀀∽̱te;䅕iãᅮmptyv;榳gȀ;del࿑らるろ;榒;榥å࿑uo耻»䂻rր;abcfhlpstw࿜ガクシスゼゾダッデナp;極Ā;f࿠ゴs;椠;椳s;椞ë≝ð✮l;楅im;楴l;憣;憝Āaiパフil;椚oĀ;nホボ戶aló༞ƀabrョリヮrò៥rk;杳ĀakンヽcĀekヹ・;䁽;䁝Āes㄂㄄;榌lĀduㄊㄌ;榎;榐Ȁaeuyㄗㄜㄧㄩron;䅙Ādiㄡㄥil;䅗ì࿲âヺ;䑀Ȁclqsㄴㄷㄽㅄa;椷dhar;楩uoĀ;rȎȍh;憳ƀacgㅎㅟངlȀ;ipsླྀㅘㅛႜnåႻarôྩt;断ƀilrㅩဣㅮsht;楽;쀀𝔯ĀaoㅷㆆrĀduㅽㅿ»ѻĀ;l႑ㆄ;楬Ā;vㆋㆌ䏁;䏱ƀgns㆕ㇹㇼht̀ahlrstㆤㆰ㇂㇘㇤㇮rrowĀ;t࿜ㆭaéトarpoonĀduㆻㆿowîㅾp»႒eftĀah㇊㇐rrowó࿪arpoonóՑightarrows;應quigarro÷ニhreetimes;拌g;䋚ingdotseñἲƀahm㈍㈐㈓rò࿪aòՑ;怏oustĀ;a㈞㈟掱che»㈟mid;櫮Ȁabpt㈲㈽㉀㉒Ānr㈷㈺g;柭r;懾rëဃƀafl㉇㉊㉎r;榆;쀀𝕣us;樮imes;樵Āap㉝㉧rĀ;g㉣㉤䀩t;榔olint;樒arò㇣Ȁachq㉻㊀Ⴜ㊅quo;怺r;쀀𝓇Ābu・㊊oĀ;rȔȓƀhir㊗㊛㊠reåㇸmes;拊iȀ;efl㊪ၙᠡ㊫方tri;槎luhar;楨;愞ൡ㋕㋛㋟㌬㌸㍱\0㍺㎤\0\0㏬㏰\0㐨㑈㑚㒭㒱㓊㓱\0㘖\0\0㘳cute;䅛quï➺Ԁ;Eaceinpsyᇭ㋳㋵㋿㌂㌋㌏㌟㌦㌩;檴ǰ㋺\0㋼;檸on;䅡uåᇾĀ;dᇳ㌇il;䅟rc;䅝ƀEas㌖㌘㌛;檶p;檺im;择olint;樓iíሄ;䑁otƀ;be㌴ᵇ㌵担;橦΀Aacmstx㍆㍊㍗㍛㍞㍣㍭rr;懘rĀhr㍐㍒ë∨Ā;oਸ਼਴t耻§䂧i;䀻war;椩mĀin㍩ðnuóñt;朶rĀ;o㍶⁕쀀𝔰Ȁacoy㎂㎆㎑㎠rp;景Āhy㎋㎏cy;䑉;䑈rtɭ㎙\0\0㎜iäᑤaraì⹯耻­䂭Āgm㎨㎴maƀ;fv㎱㎲㎲䏃;䏂Ѐ;deglnprካ㏅㏉㏎㏖㏞㏡㏦ot;橪Ā;q኱ኰĀ;E㏓㏔檞;檠Ā;E㏛㏜檝;檟e;扆lus;樤arr;楲aròᄽȀaeit㏸㐈㐏㐗Āls㏽㐄lsetmé㍪hp;樳parsl;槤Ādlᑣ㐔e;挣Ā;e㐜㐝檪Ā;s㐢㐣檬;쀀⪬︀ƀflp㐮㐳㑂tcy;䑌Ā;b㐸㐹䀯Ā;a㐾㐿槄r;挿f;쀀𝕤aĀdr㑍ЂesĀ;u㑔㑕晠it»㑕ƀcsu㑠㑹㒟Āau㑥㑯pĀ;sᆈ㑫;쀀⊓︀pĀ;sᆴ㑵;쀀⊔︀uĀbp㑿㒏ƀ;esᆗᆜ㒆etĀ;eᆗ㒍ñᆝƀ;esᆨᆭ㒖etĀ;eᆨ㒝ñᆮƀ;afᅻ㒦ְrť㒫ֱ»ᅼaròᅈȀcemt㒹㒾㓂㓅r;쀀𝓈tmîñiì㐕aræᆾĀar㓎㓕rĀ;f㓔ឿ昆Āan㓚㓭ightĀep㓣㓪psiloîỠhé⺯s»⡒ʀbcmnp㓻㕞ሉ㖋㖎Ҁ;Edemnprs㔎㔏㔑㔕㔞㔣㔬㔱㔶抂;櫅ot;檽Ā;dᇚ㔚ot;櫃ult;櫁ĀEe㔨㔪;櫋;把lus;檿arr;楹ƀeiu㔽㕒㕕tƀ;en㔎㕅㕋qĀ;qᇚ㔏eqĀ;q㔫㔨m;櫇Ābp㕚㕜;櫕;櫓c̀;acensᇭ㕬㕲㕹㕻㌦pproø㋺urlyeñᇾñᇳƀaes㖂㖈㌛pproø㌚qñ㌗g;晪ڀ123;Edehlmnps㖩㖬㖯ሜ㖲㖴㗀㗉㗕㗚㗟㗨㗭耻¹䂹耻²䂲耻³䂳;櫆Āos㖹㖼t;檾ub;櫘Ā;dሢ㗅ot;櫄sĀou㗏㗒l;柉b;櫗arr;楻ult;櫂ĀEe㗤㗦;櫌;抋lus;櫀ƀeiu㗴㘉㘌tƀ;enሜ㗼㘂qĀ;qሢ㖲eqĀ;q㗧㗤m;櫈Ābp㘑㘓;櫔;櫖ƀAan㘜㘠㘭rr;懙rĀhr㘦㘨ë∮Ā;oਫ਩war;椪lig耻ß䃟௡㙑㙝㙠ዎ㙳㙹\0㙾㛂\0\0\0\0\0㛛㜃\0㜉㝬\0\0\0㞇ɲ㙖\0\0㙛get;挖;䏄rë๟ƀaey㙦㙫㙰ron;䅥dil;䅣;䑂lrec;挕r;쀀𝔱Ȁeiko㚆㚝㚵㚼ǲ㚋\0㚑eĀ4fኄኁaƀ;sv㚘㚙㚛䎸ym;䏑Ācn㚢㚲kĀas㚨㚮pproø዁im»ኬsðኞĀas㚺㚮ð዁rn耻þ䃾Ǭ̟㛆⋧es膀×;bd㛏㛐㛘䃗Ā;aᤏ㛕r;樱;樰ƀeps㛡㛣㜀á⩍Ȁ;bcf҆㛬㛰㛴ot;挶ir;櫱Ā;o㛹㛼쀀𝕥rk;櫚á㍢rime;怴ƀaip㜏㜒㝤dåቈ΀adempst㜡㝍㝀㝑㝗㝜㝟ngleʀ;dlqr㜰㜱㜶㝀㝂斵own»ᶻeftĀ;e⠀㜾ñम;扜ightĀ;e㊪㝋ñၚot;旬inus;樺lus;樹b;槍ime;樻ezium;揢ƀcht㝲㝽㞁Āry㝷㝻;쀀𝓉;䑆cy;䑛rok;䅧Āio㞋㞎xô᝷headĀlr㞗㞠eftarro÷ࡏightarrow»ཝऀAHabcdfghlmoprstuw㟐㟓㟗㟤㟰㟼㠎㠜㠣㠴㡑㡝㡫㢩㣌㣒㣪㣶ròϭar;楣Ācr㟜㟢ute耻ú䃺òᅐrǣ㟪\0㟭y;䑞ve;䅭Āiy㟵㟺rc耻û䃻;䑃ƀabh㠃㠆㠋ròᎭlac;䅱aòᏃĀir㠓㠘sht;楾;쀀𝔲rave耻ù䃹š㠧㠱rĀlr㠬㠮»ॗ»ႃlk;斀Āct㠹㡍ɯ㠿\0\0㡊rnĀ;e㡅㡆挜r»㡆op;挏ri;旸Āal㡖㡚cr;䅫肻¨͉Āgp㡢㡦on;䅳f;쀀𝕦̀adhlsuᅋ㡸㡽፲㢑㢠ownáᎳarpoonĀlr㢈㢌efô㠭ighô㠯iƀ;hl㢙㢚㢜䏅»ᏺon»㢚parrows;懈ƀcit㢰㣄㣈ɯ㢶\0\0㣁rnĀ;e㢼㢽挝r»㢽op;挎ng;䅯ri;旹cr;쀀𝓊ƀdir㣙㣝㣢ot;拰lde;䅩iĀ;f㜰㣨»᠓Āam㣯㣲rò㢨l耻ü䃼angle;榧ހABDacdeflnoprsz㤜㤟㤩㤭㦵㦸㦽㧟㧤㧨㧳㧹㧽㨁㨠ròϷarĀ;v㤦㤧櫨;櫩asèϡĀnr㤲㤷grt;榜΀eknprst㓣㥆㥋㥒㥝㥤㦖appá␕othinçẖƀhir㓫⻈㥙opô⾵Ā;hᎷ㥢ïㆍĀiu㥩㥭gmá㎳Ābp㥲㦄setneqĀ;q㥽㦀쀀⊊︀;쀀⫋︀setneqĀ;q㦏㦒쀀⊋︀;쀀⫌︀Āhr㦛㦟etá㚜iangleĀlr㦪㦯eft»थight»ၑy;䐲ash»ံƀelr㧄㧒㧗ƀ;beⷪ㧋㧏ar;抻q;扚lip;拮Ābt㧜ᑨaòᑩr;쀀𝔳tré㦮suĀbp㧯㧱»ജ»൙pf;쀀𝕧roð໻tré㦴Ācu㨆㨋r;쀀𝓋Ābp㨐㨘nĀEe㦀㨖»㥾nĀEe㦒㨞»㦐igzag;榚΀cefoprs㨶㨻㩖㩛㩔㩡㩪irc;䅵Ādi㩀㩑Ābg㩅㩉ar;機eĀ;qᗺ㩏;扙erp;愘r;쀀𝔴pf;쀀𝕨Ā;eᑹ㩦atèᑹcr;쀀𝓌ૣណ㪇\0㪋\0㪐㪛\0\0㪝㪨㪫㪯\0\0㫃㫎\0㫘ៜ៟tré៑r;쀀𝔵ĀAa㪔㪗ròσrò৶;䎾ĀAa㪡㪤ròθrò৫að✓is;拻ƀdptឤ㪵㪾Āfl㪺ឩ;쀀𝕩imåឲĀAa㫇㫊ròώròਁĀcq㫒ីr;쀀𝓍Āpt៖㫜ré។Ѐacefiosu㫰㫽㬈㬌㬑㬕㬛㬡cĀuy㫶㫻te耻ý䃽;䑏Āiy㬂㬆rc;䅷;䑋n耻¥䂥r;쀀𝔶cy;䑗pf;쀀𝕪cr;쀀𝓎Ācm㬦㬩y;䑎l耻ÿ䃿Ԁacdefhiosw㭂㭈㭔㭘㭤㭩㭭㭴㭺㮀cute;䅺Āay㭍㭒ron;䅾;䐷ot;䅼Āet㭝㭡træᕟa;䎶r;쀀𝔷cy;䐶grarr;懝pf;쀀𝕫cr;쀀𝓏Ājn㮅㮇;怍j;怌'.split("").map((c) => c.charCodeAt(0))
  );
  var xmlDecodeTree = /* @__PURE__ */ new Uint16Array(
    // prettier-ignore
    /* @__PURE__ */ "Ȁaglq	\x1Bɭ\0\0p;䀦os;䀧t;䀾t;䀼uot;䀢".split("").map((c) => c.charCodeAt(0))
  );
  var _a;
  var decodeMap = /* @__PURE__ */ new Map([
    [0, 65533],
    // C1 Unicode control character reference replacements
    [128, 8364],
    [130, 8218],
    [131, 402],
    [132, 8222],
    [133, 8230],
    [134, 8224],
    [135, 8225],
    [136, 710],
    [137, 8240],
    [138, 352],
    [139, 8249],
    [140, 338],
    [142, 381],
    [145, 8216],
    [146, 8217],
    [147, 8220],
    [148, 8221],
    [149, 8226],
    [150, 8211],
    [151, 8212],
    [152, 732],
    [153, 8482],
    [154, 353],
    [155, 8250],
    [156, 339],
    [158, 382],
    [159, 376]
  ]);
  var fromCodePoint = (
    // eslint-disable-next-line @typescript-eslint/no-unnecessary-condition, n/no-unsupported-features/es-builtins
    (_a = String.fromCodePoint) !== null && _a !== void 0 ? _a : function(codePoint) {
      let output = "";
      if (codePoint > 65535) {
        codePoint -= 65536;
        output += String.fromCharCode(codePoint >>> 10 & 1023 | 55296);
        codePoint = 56320 | codePoint & 1023;
      }
      output += String.fromCharCode(codePoint);
      return output;
    }
  );
  function replaceCodePoint(codePoint) {
    var _a2;
    if (codePoint >= 55296 && codePoint <= 57343 || codePoint > 1114111) {
      return 65533;
    }
    return (_a2 = decodeMap.get(codePoint)) !== null && _a2 !== void 0 ? _a2 : codePoint;
  }
  var CharCodes$1;
  (function(CharCodes2) {
    CharCodes2[CharCodes2["NUM"] = 35] = "NUM";
    CharCodes2[CharCodes2["SEMI"] = 59] = "SEMI";
    CharCodes2[CharCodes2["EQUALS"] = 61] = "EQUALS";
    CharCodes2[CharCodes2["ZERO"] = 48] = "ZERO";
    CharCodes2[CharCodes2["NINE"] = 57] = "NINE";
    CharCodes2[CharCodes2["LOWER_A"] = 97] = "LOWER_A";
    CharCodes2[CharCodes2["LOWER_F"] = 102] = "LOWER_F";
    CharCodes2[CharCodes2["LOWER_X"] = 120] = "LOWER_X";
    CharCodes2[CharCodes2["LOWER_Z"] = 122] = "LOWER_Z";
    CharCodes2[CharCodes2["UPPER_A"] = 65] = "UPPER_A";
    CharCodes2[CharCodes2["UPPER_F"] = 70] = "UPPER_F";
    CharCodes2[CharCodes2["UPPER_Z"] = 90] = "UPPER_Z";
  })(CharCodes$1 || (CharCodes$1 = {}));
  var TO_LOWER_BIT = 32;
  var BinTrieFlags;
  (function(BinTrieFlags2) {
    BinTrieFlags2[BinTrieFlags2["VALUE_LENGTH"] = 49152] = "VALUE_LENGTH";
    BinTrieFlags2[BinTrieFlags2["BRANCH_LENGTH"] = 16256] = "BRANCH_LENGTH";
    BinTrieFlags2[BinTrieFlags2["JUMP_TABLE"] = 127] = "JUMP_TABLE";
  })(BinTrieFlags || (BinTrieFlags = {}));
  function isNumber(code) {
    return code >= CharCodes$1.ZERO && code <= CharCodes$1.NINE;
  }
  function isHexadecimalCharacter(code) {
    return code >= CharCodes$1.UPPER_A && code <= CharCodes$1.UPPER_F || code >= CharCodes$1.LOWER_A && code <= CharCodes$1.LOWER_F;
  }
  function isAsciiAlphaNumeric(code) {
    return code >= CharCodes$1.UPPER_A && code <= CharCodes$1.UPPER_Z || code >= CharCodes$1.LOWER_A && code <= CharCodes$1.LOWER_Z || isNumber(code);
  }
  function isEntityInAttributeInvalidEnd(code) {
    return code === CharCodes$1.EQUALS || isAsciiAlphaNumeric(code);
  }
  var EntityDecoderState;
  (function(EntityDecoderState2) {
    EntityDecoderState2[EntityDecoderState2["EntityStart"] = 0] = "EntityStart";
    EntityDecoderState2[EntityDecoderState2["NumericStart"] = 1] = "NumericStart";
    EntityDecoderState2[EntityDecoderState2["NumericDecimal"] = 2] = "NumericDecimal";
    EntityDecoderState2[EntityDecoderState2["NumericHex"] = 3] = "NumericHex";
    EntityDecoderState2[EntityDecoderState2["NamedEntity"] = 4] = "NamedEntity";
  })(EntityDecoderState || (EntityDecoderState = {}));
  var DecodingMode;
  (function(DecodingMode2) {
    DecodingMode2[DecodingMode2["Legacy"] = 0] = "Legacy";
    DecodingMode2[DecodingMode2["Strict"] = 1] = "Strict";
    DecodingMode2[DecodingMode2["Attribute"] = 2] = "Attribute";
  })(DecodingMode || (DecodingMode = {}));
  var EntityDecoder = class {
    constructor(decodeTree, emitCodePoint, errors) {
      this.decodeTree = decodeTree;
      this.emitCodePoint = emitCodePoint;
      this.errors = errors;
      this.state = EntityDecoderState.EntityStart;
      this.consumed = 1;
      this.result = 0;
      this.treeIndex = 0;
      this.excess = 1;
      this.decodeMode = DecodingMode.Strict;
    }
    /** Resets the instance to make it reusable. */
    startEntity(decodeMode) {
      this.decodeMode = decodeMode;
      this.state = EntityDecoderState.EntityStart;
      this.result = 0;
      this.treeIndex = 0;
      this.excess = 1;
      this.consumed = 1;
    }
    /**
     * Write an entity to the decoder. This can be called multiple times with partial entities.
     * If the entity is incomplete, the decoder will return -1.
     *
     * Mirrors the implementation of `getDecoder`, but with the ability to stop decoding if the
     * entity is incomplete, and resume when the next string is written.
     *
     * @param input The string containing the entity (or a continuation of the entity).
     * @param offset The offset at which the entity begins. Should be 0 if this is not the first call.
     * @returns The number of characters that were consumed, or -1 if the entity is incomplete.
     */
    write(input, offset) {
      switch (this.state) {
        case EntityDecoderState.EntityStart: {
          if (input.charCodeAt(offset) === CharCodes$1.NUM) {
            this.state = EntityDecoderState.NumericStart;
            this.consumed += 1;
            return this.stateNumericStart(input, offset + 1);
          }
          this.state = EntityDecoderState.NamedEntity;
          return this.stateNamedEntity(input, offset);
        }
        case EntityDecoderState.NumericStart: {
          return this.stateNumericStart(input, offset);
        }
        case EntityDecoderState.NumericDecimal: {
          return this.stateNumericDecimal(input, offset);
        }
        case EntityDecoderState.NumericHex: {
          return this.stateNumericHex(input, offset);
        }
        case EntityDecoderState.NamedEntity: {
          return this.stateNamedEntity(input, offset);
        }
      }
    }
    /**
     * Switches between the numeric decimal and hexadecimal states.
     *
     * Equivalent to the `Numeric character reference state` in the HTML spec.
     *
     * @param input The string containing the entity (or a continuation of the entity).
     * @param offset The current offset.
     * @returns The number of characters that were consumed, or -1 if the entity is incomplete.
     */
    stateNumericStart(input, offset) {
      if (offset >= input.length) {
        return -1;
      }
      if ((input.charCodeAt(offset) | TO_LOWER_BIT) === CharCodes$1.LOWER_X) {
        this.state = EntityDecoderState.NumericHex;
        this.consumed += 1;
        return this.stateNumericHex(input, offset + 1);
      }
      this.state = EntityDecoderState.NumericDecimal;
      return this.stateNumericDecimal(input, offset);
    }
    addToNumericResult(input, start, end2, base) {
      if (start !== end2) {
        const digitCount = end2 - start;
        this.result = this.result * Math.pow(base, digitCount) + Number.parseInt(input.substr(start, digitCount), base);
        this.consumed += digitCount;
      }
    }
    /**
     * Parses a hexadecimal numeric entity.
     *
     * Equivalent to the `Hexademical character reference state` in the HTML spec.
     *
     * @param input The string containing the entity (or a continuation of the entity).
     * @param offset The current offset.
     * @returns The number of characters that were consumed, or -1 if the entity is incomplete.
     */
    stateNumericHex(input, offset) {
      const startIndex = offset;
      while (offset < input.length) {
        const char = input.charCodeAt(offset);
        if (isNumber(char) || isHexadecimalCharacter(char)) {
          offset += 1;
        } else {
          this.addToNumericResult(input, startIndex, offset, 16);
          return this.emitNumericEntity(char, 3);
        }
      }
      this.addToNumericResult(input, startIndex, offset, 16);
      return -1;
    }
    /**
     * Parses a decimal numeric entity.
     *
     * Equivalent to the `Decimal character reference state` in the HTML spec.
     *
     * @param input The string containing the entity (or a continuation of the entity).
     * @param offset The current offset.
     * @returns The number of characters that were consumed, or -1 if the entity is incomplete.
     */
    stateNumericDecimal(input, offset) {
      const startIndex = offset;
      while (offset < input.length) {
        const char = input.charCodeAt(offset);
        if (isNumber(char)) {
          offset += 1;
        } else {
          this.addToNumericResult(input, startIndex, offset, 10);
          return this.emitNumericEntity(char, 2);
        }
      }
      this.addToNumericResult(input, startIndex, offset, 10);
      return -1;
    }
    /**
     * Validate and emit a numeric entity.
     *
     * Implements the logic from the `Hexademical character reference start
     * state` and `Numeric character reference end state` in the HTML spec.
     *
     * @param lastCp The last code point of the entity. Used to see if the
     *               entity was terminated with a semicolon.
     * @param expectedLength The minimum number of characters that should be
     *                       consumed. Used to validate that at least one digit
     *                       was consumed.
     * @returns The number of characters that were consumed.
     */
    emitNumericEntity(lastCp, expectedLength) {
      var _a2;
      if (this.consumed <= expectedLength) {
        (_a2 = this.errors) === null || _a2 === void 0 ? void 0 : _a2.absenceOfDigitsInNumericCharacterReference(this.consumed);
        return 0;
      }
      if (lastCp === CharCodes$1.SEMI) {
        this.consumed += 1;
      } else if (this.decodeMode === DecodingMode.Strict) {
        return 0;
      }
      this.emitCodePoint(replaceCodePoint(this.result), this.consumed);
      if (this.errors) {
        if (lastCp !== CharCodes$1.SEMI) {
          this.errors.missingSemicolonAfterCharacterReference();
        }
        this.errors.validateNumericCharacterReference(this.result);
      }
      return this.consumed;
    }
    /**
     * Parses a named entity.
     *
     * Equivalent to the `Named character reference state` in the HTML spec.
     *
     * @param input The string containing the entity (or a continuation of the entity).
     * @param offset The current offset.
     * @returns The number of characters that were consumed, or -1 if the entity is incomplete.
     */
    stateNamedEntity(input, offset) {
      const { decodeTree } = this;
      let current = decodeTree[this.treeIndex];
      let valueLength = (current & BinTrieFlags.VALUE_LENGTH) >> 14;
      for (; offset < input.length; offset++, this.excess++) {
        const char = input.charCodeAt(offset);
        this.treeIndex = determineBranch(decodeTree, current, this.treeIndex + Math.max(1, valueLength), char);
        if (this.treeIndex < 0) {
          return this.result === 0 || // If we are parsing an attribute
          this.decodeMode === DecodingMode.Attribute && // We shouldn't have consumed any characters after the entity,
          (valueLength === 0 || // And there should be no invalid characters.
          isEntityInAttributeInvalidEnd(char)) ? 0 : this.emitNotTerminatedNamedEntity();
        }
        current = decodeTree[this.treeIndex];
        valueLength = (current & BinTrieFlags.VALUE_LENGTH) >> 14;
        if (valueLength !== 0) {
          if (char === CharCodes$1.SEMI) {
            return this.emitNamedEntityData(this.treeIndex, valueLength, this.consumed + this.excess);
          }
          if (this.decodeMode !== DecodingMode.Strict) {
            this.result = this.treeIndex;
            this.consumed += this.excess;
            this.excess = 0;
          }
        }
      }
      return -1;
    }
    /**
     * Emit a named entity that was not terminated with a semicolon.
     *
     * @returns The number of characters consumed.
     */
    emitNotTerminatedNamedEntity() {
      var _a2;
      const { result, decodeTree } = this;
      const valueLength = (decodeTree[result] & BinTrieFlags.VALUE_LENGTH) >> 14;
      this.emitNamedEntityData(result, valueLength, this.consumed);
      (_a2 = this.errors) === null || _a2 === void 0 ? void 0 : _a2.missingSemicolonAfterCharacterReference();
      return this.consumed;
    }
    /**
     * Emit a named entity.
     *
     * @param result The index of the entity in the decode tree.
     * @param valueLength The number of bytes in the entity.
     * @param consumed The number of characters consumed.
     *
     * @returns The number of characters consumed.
     */
    emitNamedEntityData(result, valueLength, consumed) {
      const { decodeTree } = this;
      this.emitCodePoint(valueLength === 1 ? decodeTree[result] & ~BinTrieFlags.VALUE_LENGTH : decodeTree[result + 1], consumed);
      if (valueLength === 3) {
        this.emitCodePoint(decodeTree[result + 2], consumed);
      }
      return consumed;
    }
    /**
     * Signal to the parser that the end of the input was reached.
     *
     * Remaining data will be emitted and relevant errors will be produced.
     *
     * @returns The number of characters consumed.
     */
    end() {
      var _a2;
      switch (this.state) {
        case EntityDecoderState.NamedEntity: {
          return this.result !== 0 && (this.decodeMode !== DecodingMode.Attribute || this.result === this.treeIndex) ? this.emitNotTerminatedNamedEntity() : 0;
        }
        // Otherwise, emit a numeric entity if we have one.
        case EntityDecoderState.NumericDecimal: {
          return this.emitNumericEntity(0, 2);
        }
        case EntityDecoderState.NumericHex: {
          return this.emitNumericEntity(0, 3);
        }
        case EntityDecoderState.NumericStart: {
          (_a2 = this.errors) === null || _a2 === void 0 ? void 0 : _a2.absenceOfDigitsInNumericCharacterReference(this.consumed);
          return 0;
        }
        case EntityDecoderState.EntityStart: {
          return 0;
        }
      }
    }
  };
  function determineBranch(decodeTree, current, nodeIndex, char) {
    const branchCount = (current & BinTrieFlags.BRANCH_LENGTH) >> 7;
    const jumpOffset = current & BinTrieFlags.JUMP_TABLE;
    if (branchCount === 0) {
      return jumpOffset !== 0 && char === jumpOffset ? nodeIndex : -1;
    }
    if (jumpOffset) {
      const value = char - jumpOffset;
      return value < 0 || value >= branchCount ? -1 : decodeTree[nodeIndex + value] - 1;
    }
    let lo = nodeIndex;
    let hi = lo + branchCount - 1;
    while (lo <= hi) {
      const mid = lo + hi >>> 1;
      const midValue = decodeTree[mid];
      if (midValue < char) {
        lo = mid + 1;
      } else if (midValue > char) {
        hi = mid - 1;
      } else {
        return decodeTree[mid + branchCount];
      }
    }
    return -1;
  }
  var CharCodes;
  (function(CharCodes2) {
    CharCodes2[CharCodes2["Tab"] = 9] = "Tab";
    CharCodes2[CharCodes2["NewLine"] = 10] = "NewLine";
    CharCodes2[CharCodes2["FormFeed"] = 12] = "FormFeed";
    CharCodes2[CharCodes2["CarriageReturn"] = 13] = "CarriageReturn";
    CharCodes2[CharCodes2["Space"] = 32] = "Space";
    CharCodes2[CharCodes2["ExclamationMark"] = 33] = "ExclamationMark";
    CharCodes2[CharCodes2["Number"] = 35] = "Number";
    CharCodes2[CharCodes2["Amp"] = 38] = "Amp";
    CharCodes2[CharCodes2["SingleQuote"] = 39] = "SingleQuote";
    CharCodes2[CharCodes2["DoubleQuote"] = 34] = "DoubleQuote";
    CharCodes2[CharCodes2["Dash"] = 45] = "Dash";
    CharCodes2[CharCodes2["Slash"] = 47] = "Slash";
    CharCodes2[CharCodes2["Zero"] = 48] = "Zero";
    CharCodes2[CharCodes2["Nine"] = 57] = "Nine";
    CharCodes2[CharCodes2["Semi"] = 59] = "Semi";
    CharCodes2[CharCodes2["Lt"] = 60] = "Lt";
    CharCodes2[CharCodes2["Eq"] = 61] = "Eq";
    CharCodes2[CharCodes2["Gt"] = 62] = "Gt";
    CharCodes2[CharCodes2["Questionmark"] = 63] = "Questionmark";
    CharCodes2[CharCodes2["UpperA"] = 65] = "UpperA";
    CharCodes2[CharCodes2["LowerA"] = 97] = "LowerA";
    CharCodes2[CharCodes2["UpperF"] = 70] = "UpperF";
    CharCodes2[CharCodes2["LowerF"] = 102] = "LowerF";
    CharCodes2[CharCodes2["UpperZ"] = 90] = "UpperZ";
    CharCodes2[CharCodes2["LowerZ"] = 122] = "LowerZ";
    CharCodes2[CharCodes2["LowerX"] = 120] = "LowerX";
    CharCodes2[CharCodes2["OpeningSquareBracket"] = 91] = "OpeningSquareBracket";
  })(CharCodes || (CharCodes = {}));
  var State;
  (function(State2) {
    State2[State2["Text"] = 1] = "Text";
    State2[State2["BeforeTagName"] = 2] = "BeforeTagName";
    State2[State2["InTagName"] = 3] = "InTagName";
    State2[State2["InSelfClosingTag"] = 4] = "InSelfClosingTag";
    State2[State2["BeforeClosingTagName"] = 5] = "BeforeClosingTagName";
    State2[State2["InClosingTagName"] = 6] = "InClosingTagName";
    State2[State2["AfterClosingTagName"] = 7] = "AfterClosingTagName";
    State2[State2["BeforeAttributeName"] = 8] = "BeforeAttributeName";
    State2[State2["InAttributeName"] = 9] = "InAttributeName";
    State2[State2["AfterAttributeName"] = 10] = "AfterAttributeName";
    State2[State2["BeforeAttributeValue"] = 11] = "BeforeAttributeValue";
    State2[State2["InAttributeValueDq"] = 12] = "InAttributeValueDq";
    State2[State2["InAttributeValueSq"] = 13] = "InAttributeValueSq";
    State2[State2["InAttributeValueNq"] = 14] = "InAttributeValueNq";
    State2[State2["BeforeDeclaration"] = 15] = "BeforeDeclaration";
    State2[State2["InDeclaration"] = 16] = "InDeclaration";
    State2[State2["InProcessingInstruction"] = 17] = "InProcessingInstruction";
    State2[State2["BeforeComment"] = 18] = "BeforeComment";
    State2[State2["CDATASequence"] = 19] = "CDATASequence";
    State2[State2["InSpecialComment"] = 20] = "InSpecialComment";
    State2[State2["InCommentLike"] = 21] = "InCommentLike";
    State2[State2["BeforeSpecialS"] = 22] = "BeforeSpecialS";
    State2[State2["BeforeSpecialT"] = 23] = "BeforeSpecialT";
    State2[State2["SpecialStartSequence"] = 24] = "SpecialStartSequence";
    State2[State2["InSpecialTag"] = 25] = "InSpecialTag";
    State2[State2["InEntity"] = 26] = "InEntity";
  })(State || (State = {}));
  function isWhitespace$1(c) {
    return c === CharCodes.Space || c === CharCodes.NewLine || c === CharCodes.Tab || c === CharCodes.FormFeed || c === CharCodes.CarriageReturn;
  }
  function isEndOfTagSection(c) {
    return c === CharCodes.Slash || c === CharCodes.Gt || isWhitespace$1(c);
  }
  function isASCIIAlpha(c) {
    return c >= CharCodes.LowerA && c <= CharCodes.LowerZ || c >= CharCodes.UpperA && c <= CharCodes.UpperZ;
  }
  var QuoteType;
  (function(QuoteType2) {
    QuoteType2[QuoteType2["NoValue"] = 0] = "NoValue";
    QuoteType2[QuoteType2["Unquoted"] = 1] = "Unquoted";
    QuoteType2[QuoteType2["Single"] = 2] = "Single";
    QuoteType2[QuoteType2["Double"] = 3] = "Double";
  })(QuoteType || (QuoteType = {}));
  var Sequences = {
    Cdata: new Uint8Array([67, 68, 65, 84, 65, 91]),
    // CDATA[
    CdataEnd: new Uint8Array([93, 93, 62]),
    // ]]>
    CommentEnd: new Uint8Array([45, 45, 62]),
    // `-->`
    ScriptEnd: new Uint8Array([60, 47, 115, 99, 114, 105, 112, 116]),
    // `<\/script`
    StyleEnd: new Uint8Array([60, 47, 115, 116, 121, 108, 101]),
    // `</style`
    TitleEnd: new Uint8Array([60, 47, 116, 105, 116, 108, 101]),
    // `</title`
    TextareaEnd: new Uint8Array([
      60,
      47,
      116,
      101,
      120,
      116,
      97,
      114,
      101,
      97
    ]),
    // `</textarea`
    XmpEnd: new Uint8Array([60, 47, 120, 109, 112])
    // `</xmp`
  };
  var Tokenizer = class {
    constructor({ xmlMode = false, decodeEntities = true }, cbs) {
      this.cbs = cbs;
      this.state = State.Text;
      this.buffer = "";
      this.sectionStart = 0;
      this.index = 0;
      this.entityStart = 0;
      this.baseState = State.Text;
      this.isSpecial = false;
      this.running = true;
      this.offset = 0;
      this.currentSequence = void 0;
      this.sequenceIndex = 0;
      this.xmlMode = xmlMode;
      this.decodeEntities = decodeEntities;
      this.entityDecoder = new EntityDecoder(xmlMode ? xmlDecodeTree : htmlDecodeTree, (cp, consumed) => this.emitCodePoint(cp, consumed));
    }
    reset() {
      this.state = State.Text;
      this.buffer = "";
      this.sectionStart = 0;
      this.index = 0;
      this.baseState = State.Text;
      this.currentSequence = void 0;
      this.running = true;
      this.offset = 0;
    }
    write(chunk) {
      this.offset += this.buffer.length;
      this.buffer = chunk;
      this.parse();
    }
    end() {
      if (this.running)
        this.finish();
    }
    pause() {
      this.running = false;
    }
    resume() {
      this.running = true;
      if (this.index < this.buffer.length + this.offset) {
        this.parse();
      }
    }
    stateText(c) {
      if (c === CharCodes.Lt || !this.decodeEntities && this.fastForwardTo(CharCodes.Lt)) {
        if (this.index > this.sectionStart) {
          this.cbs.ontext(this.sectionStart, this.index);
        }
        this.state = State.BeforeTagName;
        this.sectionStart = this.index;
      } else if (this.decodeEntities && c === CharCodes.Amp) {
        this.startEntity();
      }
    }
    stateSpecialStartSequence(c) {
      const isEnd = this.sequenceIndex === this.currentSequence.length;
      const isMatch = isEnd ? (
        // If we are at the end of the sequence, make sure the tag name has ended
        isEndOfTagSection(c)
      ) : (
        // Otherwise, do a case-insensitive comparison
        (c | 32) === this.currentSequence[this.sequenceIndex]
      );
      if (!isMatch) {
        this.isSpecial = false;
      } else if (!isEnd) {
        this.sequenceIndex++;
        return;
      }
      this.sequenceIndex = 0;
      this.state = State.InTagName;
      this.stateInTagName(c);
    }
    /** Look for an end tag. For <title> tags, also decode entities. */
    stateInSpecialTag(c) {
      if (this.sequenceIndex === this.currentSequence.length) {
        if (c === CharCodes.Gt || isWhitespace$1(c)) {
          const endOfText = this.index - this.currentSequence.length;
          if (this.sectionStart < endOfText) {
            const actualIndex = this.index;
            this.index = endOfText;
            this.cbs.ontext(this.sectionStart, endOfText);
            this.index = actualIndex;
          }
          this.isSpecial = false;
          this.sectionStart = endOfText + 2;
          this.stateInClosingTagName(c);
          return;
        }
        this.sequenceIndex = 0;
      }
      if ((c | 32) === this.currentSequence[this.sequenceIndex]) {
        this.sequenceIndex += 1;
      } else if (this.sequenceIndex === 0) {
        if (this.currentSequence === Sequences.TitleEnd) {
          if (this.decodeEntities && c === CharCodes.Amp) {
            this.startEntity();
          }
        } else if (this.fastForwardTo(CharCodes.Lt)) {
          this.sequenceIndex = 1;
        }
      } else {
        this.sequenceIndex = Number(c === CharCodes.Lt);
      }
    }
    stateCDATASequence(c) {
      if (c === Sequences.Cdata[this.sequenceIndex]) {
        if (++this.sequenceIndex === Sequences.Cdata.length) {
          this.state = State.InCommentLike;
          this.currentSequence = Sequences.CdataEnd;
          this.sequenceIndex = 0;
          this.sectionStart = this.index + 1;
        }
      } else {
        this.sequenceIndex = 0;
        this.state = State.InDeclaration;
        this.stateInDeclaration(c);
      }
    }
    /**
     * When we wait for one specific character, we can speed things up
     * by skipping through the buffer until we find it.
     *
     * @returns Whether the character was found.
     */
    fastForwardTo(c) {
      while (++this.index < this.buffer.length + this.offset) {
        if (this.buffer.charCodeAt(this.index - this.offset) === c) {
          return true;
        }
      }
      this.index = this.buffer.length + this.offset - 1;
      return false;
    }
    /**
     * Comments and CDATA end with `-->` and `]]>`.
     *
     * Their common qualities are:
     * - Their end sequences have a distinct character they start with.
     * - That character is then repeated, so we have to check multiple repeats.
     * - All characters but the start character of the sequence can be skipped.
     */
    stateInCommentLike(c) {
      if (c === this.currentSequence[this.sequenceIndex]) {
        if (++this.sequenceIndex === this.currentSequence.length) {
          if (this.currentSequence === Sequences.CdataEnd) {
            this.cbs.oncdata(this.sectionStart, this.index, 2);
          } else {
            this.cbs.oncomment(this.sectionStart, this.index, 2);
          }
          this.sequenceIndex = 0;
          this.sectionStart = this.index + 1;
          this.state = State.Text;
        }
      } else if (this.sequenceIndex === 0) {
        if (this.fastForwardTo(this.currentSequence[0])) {
          this.sequenceIndex = 1;
        }
      } else if (c !== this.currentSequence[this.sequenceIndex - 1]) {
        this.sequenceIndex = 0;
      }
    }
    /**
     * HTML only allows ASCII alpha characters (a-z and A-Z) at the beginning of a tag name.
     *
     * XML allows a lot more characters here (@see https://www.w3.org/TR/REC-xml/#NT-NameStartChar).
     * We allow anything that wouldn't end the tag.
     */
    isTagStartChar(c) {
      return this.xmlMode ? !isEndOfTagSection(c) : isASCIIAlpha(c);
    }
    startSpecial(sequence, offset) {
      this.isSpecial = true;
      this.currentSequence = sequence;
      this.sequenceIndex = offset;
      this.state = State.SpecialStartSequence;
    }
    stateBeforeTagName(c) {
      if (c === CharCodes.ExclamationMark) {
        this.state = State.BeforeDeclaration;
        this.sectionStart = this.index + 1;
      } else if (c === CharCodes.Questionmark) {
        this.state = State.InProcessingInstruction;
        this.sectionStart = this.index + 1;
      } else if (this.isTagStartChar(c)) {
        const lower2 = c | 32;
        this.sectionStart = this.index;
        if (this.xmlMode) {
          this.state = State.InTagName;
        } else if (lower2 === Sequences.ScriptEnd[2]) {
          this.state = State.BeforeSpecialS;
        } else if (lower2 === Sequences.TitleEnd[2] || lower2 === Sequences.XmpEnd[2]) {
          this.state = State.BeforeSpecialT;
        } else {
          this.state = State.InTagName;
        }
      } else if (c === CharCodes.Slash) {
        this.state = State.BeforeClosingTagName;
      } else {
        this.state = State.Text;
        this.stateText(c);
      }
    }
    stateInTagName(c) {
      if (isEndOfTagSection(c)) {
        this.cbs.onopentagname(this.sectionStart, this.index);
        this.sectionStart = -1;
        this.state = State.BeforeAttributeName;
        this.stateBeforeAttributeName(c);
      }
    }
    stateBeforeClosingTagName(c) {
      if (isWhitespace$1(c)) ;
      else if (c === CharCodes.Gt) {
        this.state = State.Text;
      } else {
        this.state = this.isTagStartChar(c) ? State.InClosingTagName : State.InSpecialComment;
        this.sectionStart = this.index;
      }
    }
    stateInClosingTagName(c) {
      if (c === CharCodes.Gt || isWhitespace$1(c)) {
        this.cbs.onclosetag(this.sectionStart, this.index);
        this.sectionStart = -1;
        this.state = State.AfterClosingTagName;
        this.stateAfterClosingTagName(c);
      }
    }
    stateAfterClosingTagName(c) {
      if (c === CharCodes.Gt || this.fastForwardTo(CharCodes.Gt)) {
        this.state = State.Text;
        this.sectionStart = this.index + 1;
      }
    }
    stateBeforeAttributeName(c) {
      if (c === CharCodes.Gt) {
        this.cbs.onopentagend(this.index);
        if (this.isSpecial) {
          this.state = State.InSpecialTag;
          this.sequenceIndex = 0;
        } else {
          this.state = State.Text;
        }
        this.sectionStart = this.index + 1;
      } else if (c === CharCodes.Slash) {
        this.state = State.InSelfClosingTag;
      } else if (!isWhitespace$1(c)) {
        this.state = State.InAttributeName;
        this.sectionStart = this.index;
      }
    }
    stateInSelfClosingTag(c) {
      if (c === CharCodes.Gt) {
        this.cbs.onselfclosingtag(this.index);
        this.state = State.Text;
        this.sectionStart = this.index + 1;
        this.isSpecial = false;
      } else if (!isWhitespace$1(c)) {
        this.state = State.BeforeAttributeName;
        this.stateBeforeAttributeName(c);
      }
    }
    stateInAttributeName(c) {
      if (c === CharCodes.Eq || isEndOfTagSection(c)) {
        this.cbs.onattribname(this.sectionStart, this.index);
        this.sectionStart = this.index;
        this.state = State.AfterAttributeName;
        this.stateAfterAttributeName(c);
      }
    }
    stateAfterAttributeName(c) {
      if (c === CharCodes.Eq) {
        this.state = State.BeforeAttributeValue;
      } else if (c === CharCodes.Slash || c === CharCodes.Gt) {
        this.cbs.onattribend(QuoteType.NoValue, this.sectionStart);
        this.sectionStart = -1;
        this.state = State.BeforeAttributeName;
        this.stateBeforeAttributeName(c);
      } else if (!isWhitespace$1(c)) {
        this.cbs.onattribend(QuoteType.NoValue, this.sectionStart);
        this.state = State.InAttributeName;
        this.sectionStart = this.index;
      }
    }
    stateBeforeAttributeValue(c) {
      if (c === CharCodes.DoubleQuote) {
        this.state = State.InAttributeValueDq;
        this.sectionStart = this.index + 1;
      } else if (c === CharCodes.SingleQuote) {
        this.state = State.InAttributeValueSq;
        this.sectionStart = this.index + 1;
      } else if (!isWhitespace$1(c)) {
        this.sectionStart = this.index;
        this.state = State.InAttributeValueNq;
        this.stateInAttributeValueNoQuotes(c);
      }
    }
    handleInAttributeValue(c, quote) {
      if (c === quote || !this.decodeEntities && this.fastForwardTo(quote)) {
        this.cbs.onattribdata(this.sectionStart, this.index);
        this.sectionStart = -1;
        this.cbs.onattribend(quote === CharCodes.DoubleQuote ? QuoteType.Double : QuoteType.Single, this.index + 1);
        this.state = State.BeforeAttributeName;
      } else if (this.decodeEntities && c === CharCodes.Amp) {
        this.startEntity();
      }
    }
    stateInAttributeValueDoubleQuotes(c) {
      this.handleInAttributeValue(c, CharCodes.DoubleQuote);
    }
    stateInAttributeValueSingleQuotes(c) {
      this.handleInAttributeValue(c, CharCodes.SingleQuote);
    }
    stateInAttributeValueNoQuotes(c) {
      if (isWhitespace$1(c) || c === CharCodes.Gt) {
        this.cbs.onattribdata(this.sectionStart, this.index);
        this.sectionStart = -1;
        this.cbs.onattribend(QuoteType.Unquoted, this.index);
        this.state = State.BeforeAttributeName;
        this.stateBeforeAttributeName(c);
      } else if (this.decodeEntities && c === CharCodes.Amp) {
        this.startEntity();
      }
    }
    stateBeforeDeclaration(c) {
      if (c === CharCodes.OpeningSquareBracket) {
        this.state = State.CDATASequence;
        this.sequenceIndex = 0;
      } else {
        this.state = c === CharCodes.Dash ? State.BeforeComment : State.InDeclaration;
      }
    }
    stateInDeclaration(c) {
      if (c === CharCodes.Gt || this.fastForwardTo(CharCodes.Gt)) {
        this.cbs.ondeclaration(this.sectionStart, this.index);
        this.state = State.Text;
        this.sectionStart = this.index + 1;
      }
    }
    stateInProcessingInstruction(c) {
      if (c === CharCodes.Gt || this.fastForwardTo(CharCodes.Gt)) {
        this.cbs.onprocessinginstruction(this.sectionStart, this.index);
        this.state = State.Text;
        this.sectionStart = this.index + 1;
      }
    }
    stateBeforeComment(c) {
      if (c === CharCodes.Dash) {
        this.state = State.InCommentLike;
        this.currentSequence = Sequences.CommentEnd;
        this.sequenceIndex = 2;
        this.sectionStart = this.index + 1;
      } else {
        this.state = State.InDeclaration;
      }
    }
    stateInSpecialComment(c) {
      if (c === CharCodes.Gt || this.fastForwardTo(CharCodes.Gt)) {
        this.cbs.oncomment(this.sectionStart, this.index, 0);
        this.state = State.Text;
        this.sectionStart = this.index + 1;
      }
    }
    stateBeforeSpecialS(c) {
      const lower2 = c | 32;
      if (lower2 === Sequences.ScriptEnd[3]) {
        this.startSpecial(Sequences.ScriptEnd, 4);
      } else if (lower2 === Sequences.StyleEnd[3]) {
        this.startSpecial(Sequences.StyleEnd, 4);
      } else {
        this.state = State.InTagName;
        this.stateInTagName(c);
      }
    }
    stateBeforeSpecialT(c) {
      const lower2 = c | 32;
      switch (lower2) {
        case Sequences.TitleEnd[3]: {
          this.startSpecial(Sequences.TitleEnd, 4);
          break;
        }
        case Sequences.TextareaEnd[3]: {
          this.startSpecial(Sequences.TextareaEnd, 4);
          break;
        }
        case Sequences.XmpEnd[3]: {
          this.startSpecial(Sequences.XmpEnd, 4);
          break;
        }
        default: {
          this.state = State.InTagName;
          this.stateInTagName(c);
        }
      }
    }
    startEntity() {
      this.baseState = this.state;
      this.state = State.InEntity;
      this.entityStart = this.index;
      this.entityDecoder.startEntity(this.xmlMode ? DecodingMode.Strict : this.baseState === State.Text || this.baseState === State.InSpecialTag ? DecodingMode.Legacy : DecodingMode.Attribute);
    }
    stateInEntity() {
      const length = this.entityDecoder.write(this.buffer, this.index - this.offset);
      if (length >= 0) {
        this.state = this.baseState;
        if (length === 0) {
          this.index = this.entityStart;
        }
      } else {
        this.index = this.offset + this.buffer.length - 1;
      }
    }
    /**
     * Remove data that has already been consumed from the buffer.
     */
    cleanup() {
      if (this.running && this.sectionStart !== this.index) {
        if (this.state === State.Text || this.state === State.InSpecialTag && this.sequenceIndex === 0) {
          this.cbs.ontext(this.sectionStart, this.index);
          this.sectionStart = this.index;
        } else if (this.state === State.InAttributeValueDq || this.state === State.InAttributeValueSq || this.state === State.InAttributeValueNq) {
          this.cbs.onattribdata(this.sectionStart, this.index);
          this.sectionStart = this.index;
        }
      }
    }
    shouldContinue() {
      return this.index < this.buffer.length + this.offset && this.running;
    }
    /**
     * Iterates through the buffer, calling the function corresponding to the current state.
     *
     * States that are more likely to be hit are higher up, as a performance improvement.
     */
    parse() {
      while (this.shouldContinue()) {
        const c = this.buffer.charCodeAt(this.index - this.offset);
        switch (this.state) {
          case State.Text: {
            this.stateText(c);
            break;
          }
          case State.SpecialStartSequence: {
            this.stateSpecialStartSequence(c);
            break;
          }
          case State.InSpecialTag: {
            this.stateInSpecialTag(c);
            break;
          }
          case State.CDATASequence: {
            this.stateCDATASequence(c);
            break;
          }
          case State.InAttributeValueDq: {
            this.stateInAttributeValueDoubleQuotes(c);
            break;
          }
          case State.InAttributeName: {
            this.stateInAttributeName(c);
            break;
          }
          case State.InCommentLike: {
            this.stateInCommentLike(c);
            break;
          }
          case State.InSpecialComment: {
            this.stateInSpecialComment(c);
            break;
          }
          case State.BeforeAttributeName: {
            this.stateBeforeAttributeName(c);
            break;
          }
          case State.InTagName: {
            this.stateInTagName(c);
            break;
          }
          case State.InClosingTagName: {
            this.stateInClosingTagName(c);
            break;
          }
          case State.BeforeTagName: {
            this.stateBeforeTagName(c);
            break;
          }
          case State.AfterAttributeName: {
            this.stateAfterAttributeName(c);
            break;
          }
          case State.InAttributeValueSq: {
            this.stateInAttributeValueSingleQuotes(c);
            break;
          }
          case State.BeforeAttributeValue: {
            this.stateBeforeAttributeValue(c);
            break;
          }
          case State.BeforeClosingTagName: {
            this.stateBeforeClosingTagName(c);
            break;
          }
          case State.AfterClosingTagName: {
            this.stateAfterClosingTagName(c);
            break;
          }
          case State.BeforeSpecialS: {
            this.stateBeforeSpecialS(c);
            break;
          }
          case State.BeforeSpecialT: {
            this.stateBeforeSpecialT(c);
            break;
          }
          case State.InAttributeValueNq: {
            this.stateInAttributeValueNoQuotes(c);
            break;
          }
          case State.InSelfClosingTag: {
            this.stateInSelfClosingTag(c);
            break;
          }
          case State.InDeclaration: {
            this.stateInDeclaration(c);
            break;
          }
          case State.BeforeDeclaration: {
            this.stateBeforeDeclaration(c);
            break;
          }
          case State.BeforeComment: {
            this.stateBeforeComment(c);
            break;
          }
          case State.InProcessingInstruction: {
            this.stateInProcessingInstruction(c);
            break;
          }
          case State.InEntity: {
            this.stateInEntity();
            break;
          }
        }
        this.index++;
      }
      this.cleanup();
    }
    finish() {
      if (this.state === State.InEntity) {
        this.entityDecoder.end();
        this.state = this.baseState;
      }
      this.handleTrailingData();
      this.cbs.onend();
    }
    /** Handle any trailing data. */
    handleTrailingData() {
      const endIndex = this.buffer.length + this.offset;
      if (this.sectionStart >= endIndex) {
        return;
      }
      if (this.state === State.InCommentLike) {
        if (this.currentSequence === Sequences.CdataEnd) {
          this.cbs.oncdata(this.sectionStart, endIndex, 0);
        } else {
          this.cbs.oncomment(this.sectionStart, endIndex, 0);
        }
      } else if (this.state === State.InTagName || this.state === State.BeforeAttributeName || this.state === State.BeforeAttributeValue || this.state === State.AfterAttributeName || this.state === State.InAttributeName || this.state === State.InAttributeValueSq || this.state === State.InAttributeValueDq || this.state === State.InAttributeValueNq || this.state === State.InClosingTagName) ;
      else {
        this.cbs.ontext(this.sectionStart, endIndex);
      }
    }
    emitCodePoint(cp, consumed) {
      if (this.baseState !== State.Text && this.baseState !== State.InSpecialTag) {
        if (this.sectionStart < this.entityStart) {
          this.cbs.onattribdata(this.sectionStart, this.entityStart);
        }
        this.sectionStart = this.entityStart + consumed;
        this.index = this.sectionStart - 1;
        this.cbs.onattribentity(cp);
      } else {
        if (this.sectionStart < this.entityStart) {
          this.cbs.ontext(this.sectionStart, this.entityStart);
        }
        this.sectionStart = this.entityStart + consumed;
        this.index = this.sectionStart - 1;
        this.cbs.ontextentity(cp, this.sectionStart);
      }
    }
  };
  var formTags = /* @__PURE__ */ new Set([
    "input",
    "option",
    "optgroup",
    "select",
    "button",
    "datalist",
    "textarea"
  ]);
  var pTag = /* @__PURE__ */ new Set(["p"]);
  var tableSectionTags = /* @__PURE__ */ new Set(["thead", "tbody"]);
  var ddtTags = /* @__PURE__ */ new Set(["dd", "dt"]);
  var rtpTags = /* @__PURE__ */ new Set(["rt", "rp"]);
  var openImpliesClose = /* @__PURE__ */ new Map([
    ["tr", /* @__PURE__ */ new Set(["tr", "th", "td"])],
    ["th", /* @__PURE__ */ new Set(["th"])],
    ["td", /* @__PURE__ */ new Set(["thead", "th", "td"])],
    ["body", /* @__PURE__ */ new Set(["head", "link", "script"])],
    ["li", /* @__PURE__ */ new Set(["li"])],
    ["p", pTag],
    ["h1", pTag],
    ["h2", pTag],
    ["h3", pTag],
    ["h4", pTag],
    ["h5", pTag],
    ["h6", pTag],
    ["select", formTags],
    ["input", formTags],
    ["output", formTags],
    ["button", formTags],
    ["datalist", formTags],
    ["textarea", formTags],
    ["option", /* @__PURE__ */ new Set(["option"])],
    ["optgroup", /* @__PURE__ */ new Set(["optgroup", "option"])],
    ["dd", ddtTags],
    ["dt", ddtTags],
    ["address", pTag],
    ["article", pTag],
    ["aside", pTag],
    ["blockquote", pTag],
    ["details", pTag],
    ["div", pTag],
    ["dl", pTag],
    ["fieldset", pTag],
    ["figcaption", pTag],
    ["figure", pTag],
    ["footer", pTag],
    ["form", pTag],
    ["header", pTag],
    ["hr", pTag],
    ["main", pTag],
    ["nav", pTag],
    ["ol", pTag],
    ["pre", pTag],
    ["section", pTag],
    ["table", pTag],
    ["ul", pTag],
    ["rt", rtpTags],
    ["rp", rtpTags],
    ["tbody", tableSectionTags],
    ["tfoot", tableSectionTags]
  ]);
  var voidElements$1 = /* @__PURE__ */ new Set([
    "area",
    "base",
    "basefont",
    "br",
    "col",
    "command",
    "embed",
    "frame",
    "hr",
    "img",
    "input",
    "isindex",
    "keygen",
    "link",
    "meta",
    "param",
    "source",
    "track",
    "wbr"
  ]);
  var foreignContextElements = /* @__PURE__ */ new Set(["math", "svg"]);
  var htmlIntegrationElements = /* @__PURE__ */ new Set([
    "mi",
    "mo",
    "mn",
    "ms",
    "mtext",
    "annotation-xml",
    "foreignobject",
    "desc",
    "title"
  ]);
  var reNameEnd = /\s|\//;
  var Parser$1 = class Parser {
    constructor(cbs, options = {}) {
      var _a2, _b, _c, _d, _e, _f;
      this.options = options;
      this.startIndex = 0;
      this.endIndex = 0;
      this.openTagStart = 0;
      this.tagname = "";
      this.attribname = "";
      this.attribvalue = "";
      this.attribs = null;
      this.stack = [];
      this.buffers = [];
      this.bufferOffset = 0;
      this.writeIndex = 0;
      this.ended = false;
      this.cbs = cbs !== null && cbs !== void 0 ? cbs : {};
      this.htmlMode = !this.options.xmlMode;
      this.lowerCaseTagNames = (_a2 = options.lowerCaseTags) !== null && _a2 !== void 0 ? _a2 : this.htmlMode;
      this.lowerCaseAttributeNames = (_b = options.lowerCaseAttributeNames) !== null && _b !== void 0 ? _b : this.htmlMode;
      this.recognizeSelfClosing = (_c = options.recognizeSelfClosing) !== null && _c !== void 0 ? _c : !this.htmlMode;
      this.tokenizer = new ((_d = options.Tokenizer) !== null && _d !== void 0 ? _d : Tokenizer)(this.options, this);
      this.foreignContext = [!this.htmlMode];
      (_f = (_e = this.cbs).onparserinit) === null || _f === void 0 ? void 0 : _f.call(_e, this);
    }
    // Tokenizer event handlers
    /** @internal */
    ontext(start, endIndex) {
      var _a2, _b;
      const data = this.getSlice(start, endIndex);
      this.endIndex = endIndex - 1;
      (_b = (_a2 = this.cbs).ontext) === null || _b === void 0 ? void 0 : _b.call(_a2, data);
      this.startIndex = endIndex;
    }
    /** @internal */
    ontextentity(cp, endIndex) {
      var _a2, _b;
      this.endIndex = endIndex - 1;
      (_b = (_a2 = this.cbs).ontext) === null || _b === void 0 ? void 0 : _b.call(_a2, fromCodePoint(cp));
      this.startIndex = endIndex;
    }
    /**
     * Checks if the current tag is a void element. Override this if you want
     * to specify your own additional void elements.
     */
    isVoidElement(name) {
      return this.htmlMode && voidElements$1.has(name);
    }
    /** @internal */
    onopentagname(start, endIndex) {
      this.endIndex = endIndex;
      let name = this.getSlice(start, endIndex);
      if (this.lowerCaseTagNames) {
        name = name.toLowerCase();
      }
      this.emitOpenTag(name);
    }
    emitOpenTag(name) {
      var _a2, _b, _c, _d;
      this.openTagStart = this.startIndex;
      this.tagname = name;
      const impliesClose = this.htmlMode && openImpliesClose.get(name);
      if (impliesClose) {
        while (this.stack.length > 0 && impliesClose.has(this.stack[0])) {
          const element = this.stack.shift();
          (_b = (_a2 = this.cbs).onclosetag) === null || _b === void 0 ? void 0 : _b.call(_a2, element, true);
        }
      }
      if (!this.isVoidElement(name)) {
        this.stack.unshift(name);
        if (this.htmlMode) {
          if (foreignContextElements.has(name)) {
            this.foreignContext.unshift(true);
          } else if (htmlIntegrationElements.has(name)) {
            this.foreignContext.unshift(false);
          }
        }
      }
      (_d = (_c = this.cbs).onopentagname) === null || _d === void 0 ? void 0 : _d.call(_c, name);
      if (this.cbs.onopentag)
        this.attribs = {};
    }
    endOpenTag(isImplied) {
      var _a2, _b;
      this.startIndex = this.openTagStart;
      if (this.attribs) {
        (_b = (_a2 = this.cbs).onopentag) === null || _b === void 0 ? void 0 : _b.call(_a2, this.tagname, this.attribs, isImplied);
        this.attribs = null;
      }
      if (this.cbs.onclosetag && this.isVoidElement(this.tagname)) {
        this.cbs.onclosetag(this.tagname, true);
      }
      this.tagname = "";
    }
    /** @internal */
    onopentagend(endIndex) {
      this.endIndex = endIndex;
      this.endOpenTag(false);
      this.startIndex = endIndex + 1;
    }
    /** @internal */
    onclosetag(start, endIndex) {
      var _a2, _b, _c, _d, _e, _f, _g, _h;
      this.endIndex = endIndex;
      let name = this.getSlice(start, endIndex);
      if (this.lowerCaseTagNames) {
        name = name.toLowerCase();
      }
      if (this.htmlMode && (foreignContextElements.has(name) || htmlIntegrationElements.has(name))) {
        this.foreignContext.shift();
      }
      if (!this.isVoidElement(name)) {
        const pos = this.stack.indexOf(name);
        if (pos !== -1) {
          for (let index2 = 0; index2 <= pos; index2++) {
            const element = this.stack.shift();
            (_b = (_a2 = this.cbs).onclosetag) === null || _b === void 0 ? void 0 : _b.call(_a2, element, index2 !== pos);
          }
        } else if (this.htmlMode && name === "p") {
          this.emitOpenTag("p");
          this.closeCurrentTag(true);
        }
      } else if (this.htmlMode && name === "br") {
        (_d = (_c = this.cbs).onopentagname) === null || _d === void 0 ? void 0 : _d.call(_c, "br");
        (_f = (_e = this.cbs).onopentag) === null || _f === void 0 ? void 0 : _f.call(_e, "br", {}, true);
        (_h = (_g = this.cbs).onclosetag) === null || _h === void 0 ? void 0 : _h.call(_g, "br", false);
      }
      this.startIndex = endIndex + 1;
    }
    /** @internal */
    onselfclosingtag(endIndex) {
      this.endIndex = endIndex;
      if (this.recognizeSelfClosing || this.foreignContext[0]) {
        this.closeCurrentTag(false);
        this.startIndex = endIndex + 1;
      } else {
        this.onopentagend(endIndex);
      }
    }
    closeCurrentTag(isOpenImplied) {
      var _a2, _b;
      const name = this.tagname;
      this.endOpenTag(isOpenImplied);
      if (this.stack[0] === name) {
        (_b = (_a2 = this.cbs).onclosetag) === null || _b === void 0 ? void 0 : _b.call(_a2, name, !isOpenImplied);
        this.stack.shift();
      }
    }
    /** @internal */
    onattribname(start, endIndex) {
      this.startIndex = start;
      const name = this.getSlice(start, endIndex);
      this.attribname = this.lowerCaseAttributeNames ? name.toLowerCase() : name;
    }
    /** @internal */
    onattribdata(start, endIndex) {
      this.attribvalue += this.getSlice(start, endIndex);
    }
    /** @internal */
    onattribentity(cp) {
      this.attribvalue += fromCodePoint(cp);
    }
    /** @internal */
    onattribend(quote, endIndex) {
      var _a2, _b;
      this.endIndex = endIndex;
      (_b = (_a2 = this.cbs).onattribute) === null || _b === void 0 ? void 0 : _b.call(_a2, this.attribname, this.attribvalue, quote === QuoteType.Double ? '"' : quote === QuoteType.Single ? "'" : quote === QuoteType.NoValue ? void 0 : null);
      if (this.attribs && !Object.prototype.hasOwnProperty.call(this.attribs, this.attribname)) {
        this.attribs[this.attribname] = this.attribvalue;
      }
      this.attribvalue = "";
    }
    getInstructionName(value) {
      const index2 = value.search(reNameEnd);
      let name = index2 < 0 ? value : value.substr(0, index2);
      if (this.lowerCaseTagNames) {
        name = name.toLowerCase();
      }
      return name;
    }
    /** @internal */
    ondeclaration(start, endIndex) {
      this.endIndex = endIndex;
      const value = this.getSlice(start, endIndex);
      if (this.cbs.onprocessinginstruction) {
        const name = this.getInstructionName(value);
        this.cbs.onprocessinginstruction(`!${name}`, `!${value}`);
      }
      this.startIndex = endIndex + 1;
    }
    /** @internal */
    onprocessinginstruction(start, endIndex) {
      this.endIndex = endIndex;
      const value = this.getSlice(start, endIndex);
      if (this.cbs.onprocessinginstruction) {
        const name = this.getInstructionName(value);
        this.cbs.onprocessinginstruction(`?${name}`, `?${value}`);
      }
      this.startIndex = endIndex + 1;
    }
    /** @internal */
    oncomment(start, endIndex, offset) {
      var _a2, _b, _c, _d;
      this.endIndex = endIndex;
      (_b = (_a2 = this.cbs).oncomment) === null || _b === void 0 ? void 0 : _b.call(_a2, this.getSlice(start, endIndex - offset));
      (_d = (_c = this.cbs).oncommentend) === null || _d === void 0 ? void 0 : _d.call(_c);
      this.startIndex = endIndex + 1;
    }
    /** @internal */
    oncdata(start, endIndex, offset) {
      var _a2, _b, _c, _d, _e, _f, _g, _h, _j, _k;
      this.endIndex = endIndex;
      const value = this.getSlice(start, endIndex - offset);
      if (!this.htmlMode || this.options.recognizeCDATA) {
        (_b = (_a2 = this.cbs).oncdatastart) === null || _b === void 0 ? void 0 : _b.call(_a2);
        (_d = (_c = this.cbs).ontext) === null || _d === void 0 ? void 0 : _d.call(_c, value);
        (_f = (_e = this.cbs).oncdataend) === null || _f === void 0 ? void 0 : _f.call(_e);
      } else {
        (_h = (_g = this.cbs).oncomment) === null || _h === void 0 ? void 0 : _h.call(_g, `[CDATA[${value}]]`);
        (_k = (_j = this.cbs).oncommentend) === null || _k === void 0 ? void 0 : _k.call(_j);
      }
      this.startIndex = endIndex + 1;
    }
    /** @internal */
    onend() {
      var _a2, _b;
      if (this.cbs.onclosetag) {
        this.endIndex = this.startIndex;
        for (let index2 = 0; index2 < this.stack.length; index2++) {
          this.cbs.onclosetag(this.stack[index2], true);
        }
      }
      (_b = (_a2 = this.cbs).onend) === null || _b === void 0 ? void 0 : _b.call(_a2);
    }
    /**
     * Resets the parser to a blank state, ready to parse a new HTML document
     */
    reset() {
      var _a2, _b, _c, _d;
      (_b = (_a2 = this.cbs).onreset) === null || _b === void 0 ? void 0 : _b.call(_a2);
      this.tokenizer.reset();
      this.tagname = "";
      this.attribname = "";
      this.attribs = null;
      this.stack.length = 0;
      this.startIndex = 0;
      this.endIndex = 0;
      (_d = (_c = this.cbs).onparserinit) === null || _d === void 0 ? void 0 : _d.call(_c, this);
      this.buffers.length = 0;
      this.foreignContext.length = 0;
      this.foreignContext.unshift(!this.htmlMode);
      this.bufferOffset = 0;
      this.writeIndex = 0;
      this.ended = false;
    }
    /**
     * Resets the parser, then parses a complete document and
     * pushes it to the handler.
     *
     * @param data Document to parse.
     */
    parseComplete(data) {
      this.reset();
      this.end(data);
    }
    getSlice(start, end2) {
      while (start - this.bufferOffset >= this.buffers[0].length) {
        this.shiftBuffer();
      }
      let slice = this.buffers[0].slice(start - this.bufferOffset, end2 - this.bufferOffset);
      while (end2 - this.bufferOffset > this.buffers[0].length) {
        this.shiftBuffer();
        slice += this.buffers[0].slice(0, end2 - this.bufferOffset);
      }
      return slice;
    }
    shiftBuffer() {
      this.bufferOffset += this.buffers[0].length;
      this.writeIndex--;
      this.buffers.shift();
    }
    /**
     * Parses a chunk of data and calls the corresponding callbacks.
     *
     * @param chunk Chunk to parse.
     */
    write(chunk) {
      var _a2, _b;
      if (this.ended) {
        (_b = (_a2 = this.cbs).onerror) === null || _b === void 0 ? void 0 : _b.call(_a2, new Error(".write() after done!"));
        return;
      }
      this.buffers.push(chunk);
      if (this.tokenizer.running) {
        this.tokenizer.write(chunk);
        this.writeIndex++;
      }
    }
    /**
     * Parses the end of the buffer and clears the stack, calls onend.
     *
     * @param chunk Optional final chunk to parse.
     */
    end(chunk) {
      var _a2, _b;
      if (this.ended) {
        (_b = (_a2 = this.cbs).onerror) === null || _b === void 0 ? void 0 : _b.call(_a2, new Error(".end() after done!"));
        return;
      }
      if (chunk)
        this.write(chunk);
      this.ended = true;
      this.tokenizer.end();
    }
    /**
     * Pauses parsing. The parser won't emit events until `resume` is called.
     */
    pause() {
      this.tokenizer.pause();
    }
    /**
     * Resumes parsing after `pause` was called.
     */
    resume() {
      this.tokenizer.resume();
      while (this.tokenizer.running && this.writeIndex < this.buffers.length) {
        this.tokenizer.write(this.buffers[this.writeIndex++]);
      }
      if (this.ended)
        this.tokenizer.end();
    }
    /**
     * Alias of `write`, for backwards compatibility.
     *
     * @param chunk Chunk to parse.
     * @deprecated
     */
    parseChunk(chunk) {
      this.write(chunk);
    }
    /**
     * Alias of `end`, for backwards compatibility.
     *
     * @param chunk Optional final chunk to parse.
     * @deprecated
     */
    done(chunk) {
      this.end(chunk);
    }
  };
  var ElementType;
  (function(ElementType2) {
    ElementType2["Root"] = "root";
    ElementType2["Text"] = "text";
    ElementType2["Directive"] = "directive";
    ElementType2["Comment"] = "comment";
    ElementType2["Script"] = "script";
    ElementType2["Style"] = "style";
    ElementType2["Tag"] = "tag";
    ElementType2["CDATA"] = "cdata";
    ElementType2["Doctype"] = "doctype";
  })(ElementType || (ElementType = {}));
  function isTag$2(elem) {
    return elem.type === ElementType.Tag || elem.type === ElementType.Script || elem.type === ElementType.Style;
  }
  var Root = ElementType.Root;
  var Text$3 = ElementType.Text;
  var Directive = ElementType.Directive;
  var Comment$3 = ElementType.Comment;
  var Script = ElementType.Script;
  var Style = ElementType.Style;
  var Tag = ElementType.Tag;
  var CDATA$1 = ElementType.CDATA;
  var Doctype = ElementType.Doctype;
  var index = /* @__PURE__ */ Object.freeze({
    __proto__: null,
    CDATA: CDATA$1,
    Comment: Comment$3,
    Directive,
    Doctype,
    get ElementType() {
      return ElementType;
    },
    Root,
    Script,
    Style,
    Tag,
    Text: Text$3,
    isTag: isTag$2
  });
  var Node$2 = class Node {
    constructor() {
      this.parent = null;
      this.prev = null;
      this.next = null;
      this.startIndex = null;
      this.endIndex = null;
    }
    // Read-write aliases for properties
    /**
     * Same as {@link parent}.
     * [DOM spec](https://dom.spec.whatwg.org)-compatible alias.
     */
    get parentNode() {
      return this.parent;
    }
    set parentNode(parent) {
      this.parent = parent;
    }
    /**
     * Same as {@link prev}.
     * [DOM spec](https://dom.spec.whatwg.org)-compatible alias.
     */
    get previousSibling() {
      return this.prev;
    }
    set previousSibling(prev) {
      this.prev = prev;
    }
    /**
     * Same as {@link next}.
     * [DOM spec](https://dom.spec.whatwg.org)-compatible alias.
     */
    get nextSibling() {
      return this.next;
    }
    set nextSibling(next) {
      this.next = next;
    }
    /**
     * Clone this node, and optionally its children.
     *
     * @param recursive Clone child nodes as well.
     * @returns A clone of the node.
     */
    cloneNode(recursive = false) {
      return cloneNode(this, recursive);
    }
  };
  var DataNode = class extends Node$2 {
    /**
     * @param data The content of the data node
     */
    constructor(data) {
      super();
      this.data = data;
    }
    /**
     * Same as {@link data}.
     * [DOM spec](https://dom.spec.whatwg.org)-compatible alias.
     */
    get nodeValue() {
      return this.data;
    }
    set nodeValue(data) {
      this.data = data;
    }
  };
  var Text$2 = class Text extends DataNode {
    constructor() {
      super(...arguments);
      this.type = ElementType.Text;
    }
    get nodeType() {
      return 3;
    }
  };
  var Comment$2 = class Comment extends DataNode {
    constructor() {
      super(...arguments);
      this.type = ElementType.Comment;
    }
    get nodeType() {
      return 8;
    }
  };
  var ProcessingInstruction = class extends DataNode {
    constructor(name, data) {
      super(data);
      this.name = name;
      this.type = ElementType.Directive;
    }
    get nodeType() {
      return 1;
    }
  };
  var NodeWithChildren = class extends Node$2 {
    /**
     * @param children Children of the node. Only certain node types can have children.
     */
    constructor(children) {
      super();
      this.children = children;
    }
    // Aliases
    /** First child of the node. */
    get firstChild() {
      var _a2;
      return (_a2 = this.children[0]) !== null && _a2 !== void 0 ? _a2 : null;
    }
    /** Last child of the node. */
    get lastChild() {
      return this.children.length > 0 ? this.children[this.children.length - 1] : null;
    }
    /**
     * Same as {@link children}.
     * [DOM spec](https://dom.spec.whatwg.org)-compatible alias.
     */
    get childNodes() {
      return this.children;
    }
    set childNodes(children) {
      this.children = children;
    }
  };
  var CDATA = class extends NodeWithChildren {
    constructor() {
      super(...arguments);
      this.type = ElementType.CDATA;
    }
    get nodeType() {
      return 4;
    }
  };
  var Document$2 = class Document extends NodeWithChildren {
    constructor() {
      super(...arguments);
      this.type = ElementType.Root;
    }
    get nodeType() {
      return 9;
    }
  };
  var Element$2 = class Element extends NodeWithChildren {
    /**
     * @param name Name of the tag, eg. `div`, `span`.
     * @param attribs Object mapping attribute names to attribute values.
     * @param children Children of the node.
     */
    constructor(name, attribs, children = [], type = name === "script" ? ElementType.Script : name === "style" ? ElementType.Style : ElementType.Tag) {
      super(children);
      this.name = name;
      this.attribs = attribs;
      this.type = type;
    }
    get nodeType() {
      return 1;
    }
    // DOM Level 1 aliases
    /**
     * Same as {@link name}.
     * [DOM spec](https://dom.spec.whatwg.org)-compatible alias.
     */
    get tagName() {
      return this.name;
    }
    set tagName(name) {
      this.name = name;
    }
    get attributes() {
      return Object.keys(this.attribs).map((name) => {
        var _a2, _b;
        return {
          name,
          value: this.attribs[name],
          namespace: (_a2 = this["x-attribsNamespace"]) === null || _a2 === void 0 ? void 0 : _a2[name],
          prefix: (_b = this["x-attribsPrefix"]) === null || _b === void 0 ? void 0 : _b[name]
        };
      });
    }
  };
  function isTag$1(node) {
    return isTag$2(node);
  }
  function isCDATA(node) {
    return node.type === ElementType.CDATA;
  }
  function isText(node) {
    return node.type === ElementType.Text;
  }
  function isComment(node) {
    return node.type === ElementType.Comment;
  }
  function isDirective(node) {
    return node.type === ElementType.Directive;
  }
  function isDocument(node) {
    return node.type === ElementType.Root;
  }
  function hasChildren(node) {
    return Object.prototype.hasOwnProperty.call(node, "children");
  }
  function cloneNode(node, recursive = false) {
    let result;
    if (isText(node)) {
      result = new Text$2(node.data);
    } else if (isComment(node)) {
      result = new Comment$2(node.data);
    } else if (isTag$1(node)) {
      const children = recursive ? cloneChildren(node.children) : [];
      const clone2 = new Element$2(node.name, { ...node.attribs }, children);
      children.forEach((child) => child.parent = clone2);
      if (node.namespace != null) {
        clone2.namespace = node.namespace;
      }
      if (node["x-attribsNamespace"]) {
        clone2["x-attribsNamespace"] = { ...node["x-attribsNamespace"] };
      }
      if (node["x-attribsPrefix"]) {
        clone2["x-attribsPrefix"] = { ...node["x-attribsPrefix"] };
      }
      result = clone2;
    } else if (isCDATA(node)) {
      const children = recursive ? cloneChildren(node.children) : [];
      const clone2 = new CDATA(children);
      children.forEach((child) => child.parent = clone2);
      result = clone2;
    } else if (isDocument(node)) {
      const children = recursive ? cloneChildren(node.children) : [];
      const clone2 = new Document$2(children);
      children.forEach((child) => child.parent = clone2);
      if (node["x-mode"]) {
        clone2["x-mode"] = node["x-mode"];
      }
      result = clone2;
    } else if (isDirective(node)) {
      const instruction = new ProcessingInstruction(node.name, node.data);
      if (node["x-name"] != null) {
        instruction["x-name"] = node["x-name"];
        instruction["x-publicId"] = node["x-publicId"];
        instruction["x-systemId"] = node["x-systemId"];
      }
      result = instruction;
    } else {
      throw new Error(`Not implemented yet: ${node.type}`);
    }
    result.startIndex = node.startIndex;
    result.endIndex = node.endIndex;
    if (node.sourceCodeLocation != null) {
      result.sourceCodeLocation = node.sourceCodeLocation;
    }
    return result;
  }
  function cloneChildren(childs) {
    const children = childs.map((child) => cloneNode(child, true));
    for (let i = 1; i < children.length; i++) {
      children[i].prev = children[i - 1];
      children[i - 1].next = children[i];
    }
    return children;
  }
  var defaultOpts = {
    withStartIndices: false,
    withEndIndices: false,
    xmlMode: false
  };
  var DomHandler = class {
    /**
     * @param callback Called once parsing has completed.
     * @param options Settings for the handler.
     * @param elementCB Callback whenever a tag is closed.
     */
    constructor(callback, options, elementCB) {
      this.dom = [];
      this.root = new Document$2(this.dom);
      this.done = false;
      this.tagStack = [this.root];
      this.lastNode = null;
      this.parser = null;
      if (typeof options === "function") {
        elementCB = options;
        options = defaultOpts;
      }
      if (typeof callback === "object") {
        options = callback;
        callback = void 0;
      }
      this.callback = callback !== null && callback !== void 0 ? callback : null;
      this.options = options !== null && options !== void 0 ? options : defaultOpts;
      this.elementCB = elementCB !== null && elementCB !== void 0 ? elementCB : null;
    }
    onparserinit(parser) {
      this.parser = parser;
    }
    // Resets the handler back to starting state
    onreset() {
      this.dom = [];
      this.root = new Document$2(this.dom);
      this.done = false;
      this.tagStack = [this.root];
      this.lastNode = null;
      this.parser = null;
    }
    // Signals the handler that parsing is done
    onend() {
      if (this.done)
        return;
      this.done = true;
      this.parser = null;
      this.handleCallback(null);
    }
    onerror(error) {
      this.handleCallback(error);
    }
    onclosetag() {
      this.lastNode = null;
      const elem = this.tagStack.pop();
      if (this.options.withEndIndices) {
        elem.endIndex = this.parser.endIndex;
      }
      if (this.elementCB)
        this.elementCB(elem);
    }
    onopentag(name, attribs) {
      const type = this.options.xmlMode ? ElementType.Tag : void 0;
      const element = new Element$2(name, attribs, void 0, type);
      this.addNode(element);
      this.tagStack.push(element);
    }
    ontext(data) {
      const { lastNode } = this;
      if (lastNode && lastNode.type === ElementType.Text) {
        lastNode.data += data;
        if (this.options.withEndIndices) {
          lastNode.endIndex = this.parser.endIndex;
        }
      } else {
        const node = new Text$2(data);
        this.addNode(node);
        this.lastNode = node;
      }
    }
    oncomment(data) {
      if (this.lastNode && this.lastNode.type === ElementType.Comment) {
        this.lastNode.data += data;
        return;
      }
      const node = new Comment$2(data);
      this.addNode(node);
      this.lastNode = node;
    }
    oncommentend() {
      this.lastNode = null;
    }
    oncdatastart() {
      const text3 = new Text$2("");
      const node = new CDATA([text3]);
      this.addNode(node);
      text3.parent = node;
      this.lastNode = text3;
    }
    oncdataend() {
      this.lastNode = null;
    }
    onprocessinginstruction(name, data) {
      const node = new ProcessingInstruction(name, data);
      this.addNode(node);
    }
    handleCallback(error) {
      if (typeof this.callback === "function") {
        this.callback(error, this.dom);
      } else if (error) {
        throw error;
      }
    }
    addNode(node) {
      const parent = this.tagStack[this.tagStack.length - 1];
      const previousSibling2 = parent.children[parent.children.length - 1];
      if (this.options.withStartIndices) {
        node.startIndex = this.parser.startIndex;
      }
      if (this.options.withEndIndices) {
        node.endIndex = this.parser.endIndex;
      }
      parent.children.push(node);
      if (previousSibling2) {
        node.prev = previousSibling2;
        previousSibling2.next = node;
      }
      node.parent = parent;
      this.lastNode = null;
    }
  };
  var xmlReplacer = /["&'<>$\x80-\uFFFF]/g;
  var xmlCodeMap = /* @__PURE__ */ new Map([
    [34, "&quot;"],
    [38, "&amp;"],
    [39, "&apos;"],
    [60, "&lt;"],
    [62, "&gt;"]
  ]);
  var getCodePoint = (
    // eslint-disable-next-line @typescript-eslint/no-unnecessary-condition
    String.prototype.codePointAt != null ? (str, index2) => str.codePointAt(index2) : (
      // http://mathiasbynens.be/notes/javascript-encoding#surrogate-formulae
      (c, index2) => (c.charCodeAt(index2) & 64512) === 55296 ? (c.charCodeAt(index2) - 55296) * 1024 + c.charCodeAt(index2 + 1) - 56320 + 65536 : c.charCodeAt(index2)
    )
  );
  function encodeXML(str) {
    let ret = "";
    let lastIdx = 0;
    let match;
    while ((match = xmlReplacer.exec(str)) !== null) {
      const i = match.index;
      const char = str.charCodeAt(i);
      const next = xmlCodeMap.get(char);
      if (next !== void 0) {
        ret += str.substring(lastIdx, i) + next;
        lastIdx = i + 1;
      } else {
        ret += `${str.substring(lastIdx, i)}&#x${getCodePoint(str, i).toString(16)};`;
        lastIdx = xmlReplacer.lastIndex += Number((char & 64512) === 55296);
      }
    }
    return ret + str.substr(lastIdx);
  }
  function getEscaper(regex, map) {
    return function escape2(data) {
      let match;
      let lastIdx = 0;
      let result = "";
      while (match = regex.exec(data)) {
        if (lastIdx !== match.index) {
          result += data.substring(lastIdx, match.index);
        }
        result += map.get(match[0].charCodeAt(0));
        lastIdx = match.index + 1;
      }
      return result + data.substring(lastIdx);
    };
  }
  var escapeAttribute = getEscaper(/["&\u00A0]/g, /* @__PURE__ */ new Map([
    [34, "&quot;"],
    [38, "&amp;"],
    [160, "&nbsp;"]
  ]));
  var escapeText = getEscaper(/[&<>\u00A0]/g, /* @__PURE__ */ new Map([
    [38, "&amp;"],
    [60, "&lt;"],
    [62, "&gt;"],
    [160, "&nbsp;"]
  ]));
  var elementNames = new Map([
    "altGlyph",
    "altGlyphDef",
    "altGlyphItem",
    "animateColor",
    "animateMotion",
    "animateTransform",
    "clipPath",
    "feBlend",
    "feColorMatrix",
    "feComponentTransfer",
    "feComposite",
    "feConvolveMatrix",
    "feDiffuseLighting",
    "feDisplacementMap",
    "feDistantLight",
    "feDropShadow",
    "feFlood",
    "feFuncA",
    "feFuncB",
    "feFuncG",
    "feFuncR",
    "feGaussianBlur",
    "feImage",
    "feMerge",
    "feMergeNode",
    "feMorphology",
    "feOffset",
    "fePointLight",
    "feSpecularLighting",
    "feSpotLight",
    "feTile",
    "feTurbulence",
    "foreignObject",
    "glyphRef",
    "linearGradient",
    "radialGradient",
    "textPath"
  ].map((val) => [val.toLowerCase(), val]));
  var attributeNames = new Map([
    "definitionURL",
    "attributeName",
    "attributeType",
    "baseFrequency",
    "baseProfile",
    "calcMode",
    "clipPathUnits",
    "diffuseConstant",
    "edgeMode",
    "filterUnits",
    "glyphRef",
    "gradientTransform",
    "gradientUnits",
    "kernelMatrix",
    "kernelUnitLength",
    "keyPoints",
    "keySplines",
    "keyTimes",
    "lengthAdjust",
    "limitingConeAngle",
    "markerHeight",
    "markerUnits",
    "markerWidth",
    "maskContentUnits",
    "maskUnits",
    "numOctaves",
    "pathLength",
    "patternContentUnits",
    "patternTransform",
    "patternUnits",
    "pointsAtX",
    "pointsAtY",
    "pointsAtZ",
    "preserveAlpha",
    "preserveAspectRatio",
    "primitiveUnits",
    "refX",
    "refY",
    "repeatCount",
    "repeatDur",
    "requiredExtensions",
    "requiredFeatures",
    "specularConstant",
    "specularExponent",
    "spreadMethod",
    "startOffset",
    "stdDeviation",
    "stitchTiles",
    "surfaceScale",
    "systemLanguage",
    "tableValues",
    "targetX",
    "targetY",
    "textLength",
    "viewBox",
    "viewTarget",
    "xChannelSelector",
    "yChannelSelector",
    "zoomAndPan"
  ].map((val) => [val.toLowerCase(), val]));
  var unencodedElements = /* @__PURE__ */ new Set([
    "style",
    "script",
    "xmp",
    "iframe",
    "noembed",
    "noframes",
    "plaintext",
    "noscript"
  ]);
  function replaceQuotes(value) {
    return value.replace(/"/g, "&quot;");
  }
  function formatAttributes(attributes2, opts) {
    var _a2;
    if (!attributes2)
      return;
    const encode = ((_a2 = opts.encodeEntities) !== null && _a2 !== void 0 ? _a2 : opts.decodeEntities) === false ? replaceQuotes : opts.xmlMode || opts.encodeEntities !== "utf8" ? encodeXML : escapeAttribute;
    return Object.keys(attributes2).map((key2) => {
      var _a3, _b;
      const value = (_a3 = attributes2[key2]) !== null && _a3 !== void 0 ? _a3 : "";
      if (opts.xmlMode === "foreign") {
        key2 = (_b = attributeNames.get(key2)) !== null && _b !== void 0 ? _b : key2;
      }
      if (!opts.emptyAttrs && !opts.xmlMode && value === "") {
        return key2;
      }
      return `${key2}="${encode(value)}"`;
    }).join(" ");
  }
  var singleTag = /* @__PURE__ */ new Set([
    "area",
    "base",
    "basefont",
    "br",
    "col",
    "command",
    "embed",
    "frame",
    "hr",
    "img",
    "input",
    "isindex",
    "keygen",
    "link",
    "meta",
    "param",
    "source",
    "track",
    "wbr"
  ]);
  function render(node, options = {}) {
    const nodes = "length" in node ? node : [node];
    let output = "";
    for (let i = 0; i < nodes.length; i++) {
      output += renderNode(nodes[i], options);
    }
    return output;
  }
  function renderNode(node, options) {
    switch (node.type) {
      case Root:
        return render(node.children, options);
      // @ts-expect-error We don't use `Doctype` yet
      case Doctype:
      case Directive:
        return renderDirective(node);
      case Comment$3:
        return renderComment(node);
      case CDATA$1:
        return renderCdata(node);
      case Script:
      case Style:
      case Tag:
        return renderTag(node, options);
      case Text$3:
        return renderText(node, options);
    }
  }
  var foreignModeIntegrationPoints = /* @__PURE__ */ new Set([
    "mi",
    "mo",
    "mn",
    "ms",
    "mtext",
    "annotation-xml",
    "foreignObject",
    "desc",
    "title"
  ]);
  var foreignElements = /* @__PURE__ */ new Set(["svg", "math"]);
  function renderTag(elem, opts) {
    var _a2;
    if (opts.xmlMode === "foreign") {
      elem.name = (_a2 = elementNames.get(elem.name)) !== null && _a2 !== void 0 ? _a2 : elem.name;
      if (elem.parent && foreignModeIntegrationPoints.has(elem.parent.name)) {
        opts = { ...opts, xmlMode: false };
      }
    }
    if (!opts.xmlMode && foreignElements.has(elem.name)) {
      opts = { ...opts, xmlMode: "foreign" };
    }
    let tag = `<${elem.name}`;
    const attribs = formatAttributes(elem.attribs, opts);
    if (attribs) {
      tag += ` ${attribs}`;
    }
    if (elem.children.length === 0 && (opts.xmlMode ? (
      // In XML mode or foreign mode, and user hasn't explicitly turned off self-closing tags
      opts.selfClosingTags !== false
    ) : (
      // User explicitly asked for self-closing tags, even in HTML mode
      opts.selfClosingTags && singleTag.has(elem.name)
    ))) {
      if (!opts.xmlMode)
        tag += " ";
      tag += "/>";
    } else {
      tag += ">";
      if (elem.children.length > 0) {
        tag += render(elem.children, opts);
      }
      if (opts.xmlMode || !singleTag.has(elem.name)) {
        tag += `</${elem.name}>`;
      }
    }
    return tag;
  }
  function renderDirective(elem) {
    return `<${elem.data}>`;
  }
  function renderText(elem, opts) {
    var _a2;
    let data = elem.data || "";
    if (((_a2 = opts.encodeEntities) !== null && _a2 !== void 0 ? _a2 : opts.decodeEntities) !== false && !(!opts.xmlMode && elem.parent && unencodedElements.has(elem.parent.name))) {
      data = opts.xmlMode || opts.encodeEntities !== "utf8" ? encodeXML(data) : escapeText(data);
    }
    return data;
  }
  function renderCdata(elem) {
    return `<![CDATA[${elem.children[0].data}]]>`;
  }
  function renderComment(elem) {
    return `<!--${elem.data}-->`;
  }
  function getOuterHTML(node, options) {
    return render(node, options);
  }
  function getInnerHTML(node, options) {
    return hasChildren(node) ? node.children.map((node2) => getOuterHTML(node2, options)).join("") : "";
  }
  function getText$1(node) {
    if (Array.isArray(node))
      return node.map(getText$1).join("");
    if (isTag$1(node))
      return node.name === "br" ? "\n" : getText$1(node.children);
    if (isCDATA(node))
      return getText$1(node.children);
    if (isText(node))
      return node.data;
    return "";
  }
  function textContent(node) {
    if (Array.isArray(node))
      return node.map(textContent).join("");
    if (hasChildren(node) && !isComment(node)) {
      return textContent(node.children);
    }
    if (isText(node))
      return node.data;
    return "";
  }
  function innerText(node) {
    if (Array.isArray(node))
      return node.map(innerText).join("");
    if (hasChildren(node) && (node.type === ElementType.Tag || isCDATA(node))) {
      return innerText(node.children);
    }
    if (isText(node))
      return node.data;
    return "";
  }
  function getChildren$1(elem) {
    return hasChildren(elem) ? elem.children : [];
  }
  function getParent$1(elem) {
    return elem.parent || null;
  }
  function getSiblings$1(elem) {
    const parent = getParent$1(elem);
    if (parent != null)
      return getChildren$1(parent);
    const siblings = [elem];
    let { prev, next } = elem;
    while (prev != null) {
      siblings.unshift(prev);
      ({ prev } = prev);
    }
    while (next != null) {
      siblings.push(next);
      ({ next } = next);
    }
    return siblings;
  }
  function getAttributeValue$1(elem, name) {
    var _a2;
    return (_a2 = elem.attribs) === null || _a2 === void 0 ? void 0 : _a2[name];
  }
  function hasAttrib$1(elem, name) {
    return elem.attribs != null && Object.prototype.hasOwnProperty.call(elem.attribs, name) && elem.attribs[name] != null;
  }
  function getName$1(elem) {
    return elem.name;
  }
  function nextElementSibling$1(elem) {
    let { next } = elem;
    while (next !== null && !isTag$1(next))
      ({ next } = next);
    return next;
  }
  function prevElementSibling(elem) {
    let { prev } = elem;
    while (prev !== null && !isTag$1(prev))
      ({ prev } = prev);
    return prev;
  }
  function removeElement(elem) {
    if (elem.prev)
      elem.prev.next = elem.next;
    if (elem.next)
      elem.next.prev = elem.prev;
    if (elem.parent) {
      const childs = elem.parent.children;
      const childsIndex = childs.lastIndexOf(elem);
      if (childsIndex >= 0) {
        childs.splice(childsIndex, 1);
      }
    }
    elem.next = null;
    elem.prev = null;
    elem.parent = null;
  }
  function replaceElement(elem, replacement) {
    const prev = replacement.prev = elem.prev;
    if (prev) {
      prev.next = replacement;
    }
    const next = replacement.next = elem.next;
    if (next) {
      next.prev = replacement;
    }
    const parent = replacement.parent = elem.parent;
    if (parent) {
      const childs = parent.children;
      childs[childs.lastIndexOf(elem)] = replacement;
      elem.parent = null;
    }
  }
  function appendChild(parent, child) {
    removeElement(child);
    child.next = null;
    child.parent = parent;
    if (parent.children.push(child) > 1) {
      const sibling = parent.children[parent.children.length - 2];
      sibling.next = child;
      child.prev = sibling;
    } else {
      child.prev = null;
    }
  }
  function append$2(elem, next) {
    removeElement(next);
    const { parent } = elem;
    const currNext = elem.next;
    next.next = currNext;
    next.prev = elem;
    elem.next = next;
    next.parent = parent;
    if (currNext) {
      currNext.prev = next;
      if (parent) {
        const childs = parent.children;
        childs.splice(childs.lastIndexOf(currNext), 0, next);
      }
    } else if (parent) {
      parent.children.push(next);
    }
  }
  function prependChild(parent, child) {
    removeElement(child);
    child.parent = parent;
    child.prev = null;
    if (parent.children.unshift(child) !== 1) {
      const sibling = parent.children[1];
      sibling.prev = child;
      child.next = sibling;
    } else {
      child.next = null;
    }
  }
  function prepend(elem, prev) {
    removeElement(prev);
    const { parent } = elem;
    if (parent) {
      const childs = parent.children;
      childs.splice(childs.indexOf(elem), 0, prev);
    }
    if (elem.prev) {
      elem.prev.next = prev;
    }
    prev.parent = parent;
    prev.prev = elem.prev;
    prev.next = elem;
    elem.prev = prev;
  }
  function filter(test, node, recurse = true, limit = Infinity) {
    return find(test, Array.isArray(node) ? node : [node], recurse, limit);
  }
  function find(test, nodes, recurse, limit) {
    const result = [];
    const nodeStack = [Array.isArray(nodes) ? nodes : [nodes]];
    const indexStack = [0];
    for (; ; ) {
      if (indexStack[0] >= nodeStack[0].length) {
        if (indexStack.length === 1) {
          return result;
        }
        nodeStack.shift();
        indexStack.shift();
        continue;
      }
      const elem = nodeStack[0][indexStack[0]++];
      if (test(elem)) {
        result.push(elem);
        if (--limit <= 0)
          return result;
      }
      if (recurse && hasChildren(elem) && elem.children.length > 0) {
        indexStack.unshift(0);
        nodeStack.unshift(elem.children);
      }
    }
  }
  function findOneChild(test, nodes) {
    return nodes.find(test);
  }
  function findOne$1(test, nodes, recurse = true) {
    const searchedNodes = Array.isArray(nodes) ? nodes : [nodes];
    for (let i = 0; i < searchedNodes.length; i++) {
      const node = searchedNodes[i];
      if (isTag$1(node) && test(node)) {
        return node;
      }
      if (recurse && hasChildren(node) && node.children.length > 0) {
        const found = findOne$1(test, node.children, true);
        if (found)
          return found;
      }
    }
    return null;
  }
  function existsOne$1(test, nodes) {
    return (Array.isArray(nodes) ? nodes : [nodes]).some((node) => isTag$1(node) && test(node) || hasChildren(node) && existsOne$1(test, node.children));
  }
  function findAll$1(test, nodes) {
    const result = [];
    const nodeStack = [Array.isArray(nodes) ? nodes : [nodes]];
    const indexStack = [0];
    for (; ; ) {
      if (indexStack[0] >= nodeStack[0].length) {
        if (nodeStack.length === 1) {
          return result;
        }
        nodeStack.shift();
        indexStack.shift();
        continue;
      }
      const elem = nodeStack[0][indexStack[0]++];
      if (isTag$1(elem) && test(elem))
        result.push(elem);
      if (hasChildren(elem) && elem.children.length > 0) {
        indexStack.unshift(0);
        nodeStack.unshift(elem.children);
      }
    }
  }
  var Checks = {
    tag_name(name) {
      if (typeof name === "function") {
        return (elem) => isTag$1(elem) && name(elem.name);
      } else if (name === "*") {
        return isTag$1;
      }
      return (elem) => isTag$1(elem) && elem.name === name;
    },
    tag_type(type) {
      if (typeof type === "function") {
        return (elem) => type(elem.type);
      }
      return (elem) => elem.type === type;
    },
    tag_contains(data) {
      if (typeof data === "function") {
        return (elem) => isText(elem) && data(elem.data);
      }
      return (elem) => isText(elem) && elem.data === data;
    }
  };
  function getAttribCheck(attrib, value) {
    if (typeof value === "function") {
      return (elem) => isTag$1(elem) && value(elem.attribs[attrib]);
    }
    return (elem) => isTag$1(elem) && elem.attribs[attrib] === value;
  }
  function combineFuncs(a, b) {
    return (elem) => a(elem) || b(elem);
  }
  function compileTest(options) {
    const funcs = Object.keys(options).map((key2) => {
      const value = options[key2];
      return Object.prototype.hasOwnProperty.call(Checks, key2) ? Checks[key2](value) : getAttribCheck(key2, value);
    });
    return funcs.length === 0 ? null : funcs.reduce(combineFuncs);
  }
  function testElement(options, node) {
    const test = compileTest(options);
    return test ? test(node) : true;
  }
  function getElements(options, nodes, recurse, limit = Infinity) {
    const test = compileTest(options);
    return test ? filter(test, nodes, recurse, limit) : [];
  }
  function getElementById(id, nodes, recurse = true) {
    if (!Array.isArray(nodes))
      nodes = [nodes];
    return findOne$1(getAttribCheck("id", id), nodes, recurse);
  }
  function getElementsByTagName(tagName2, nodes, recurse = true, limit = Infinity) {
    return filter(Checks["tag_name"](tagName2), nodes, recurse, limit);
  }
  function getElementsByClassName(className, nodes, recurse = true, limit = Infinity) {
    return filter(getAttribCheck("class", className), nodes, recurse, limit);
  }
  function getElementsByTagType(type, nodes, recurse = true, limit = Infinity) {
    return filter(Checks["tag_type"](type), nodes, recurse, limit);
  }
  function removeSubsets$1(nodes) {
    let idx = nodes.length;
    while (--idx >= 0) {
      const node = nodes[idx];
      if (idx > 0 && nodes.lastIndexOf(node, idx - 1) >= 0) {
        nodes.splice(idx, 1);
        continue;
      }
      for (let ancestor = node.parent; ancestor; ancestor = ancestor.parent) {
        if (nodes.includes(ancestor)) {
          nodes.splice(idx, 1);
          break;
        }
      }
    }
    return nodes;
  }
  var DocumentPosition;
  (function(DocumentPosition2) {
    DocumentPosition2[DocumentPosition2["DISCONNECTED"] = 1] = "DISCONNECTED";
    DocumentPosition2[DocumentPosition2["PRECEDING"] = 2] = "PRECEDING";
    DocumentPosition2[DocumentPosition2["FOLLOWING"] = 4] = "FOLLOWING";
    DocumentPosition2[DocumentPosition2["CONTAINS"] = 8] = "CONTAINS";
    DocumentPosition2[DocumentPosition2["CONTAINED_BY"] = 16] = "CONTAINED_BY";
  })(DocumentPosition || (DocumentPosition = {}));
  function compareDocumentPosition(nodeA, nodeB) {
    const aParents = [];
    const bParents = [];
    if (nodeA === nodeB) {
      return 0;
    }
    let current = hasChildren(nodeA) ? nodeA : nodeA.parent;
    while (current) {
      aParents.unshift(current);
      current = current.parent;
    }
    current = hasChildren(nodeB) ? nodeB : nodeB.parent;
    while (current) {
      bParents.unshift(current);
      current = current.parent;
    }
    const maxIdx = Math.min(aParents.length, bParents.length);
    let idx = 0;
    while (idx < maxIdx && aParents[idx] === bParents[idx]) {
      idx++;
    }
    if (idx === 0) {
      return DocumentPosition.DISCONNECTED;
    }
    const sharedParent = aParents[idx - 1];
    const siblings = sharedParent.children;
    const aSibling = aParents[idx];
    const bSibling = bParents[idx];
    if (siblings.indexOf(aSibling) > siblings.indexOf(bSibling)) {
      if (sharedParent === nodeB) {
        return DocumentPosition.FOLLOWING | DocumentPosition.CONTAINED_BY;
      }
      return DocumentPosition.FOLLOWING;
    }
    if (sharedParent === nodeA) {
      return DocumentPosition.PRECEDING | DocumentPosition.CONTAINS;
    }
    return DocumentPosition.PRECEDING;
  }
  function uniqueSort(nodes) {
    nodes = nodes.filter((node, i, arr) => !arr.includes(node, i + 1));
    nodes.sort((a, b) => {
      const relative = compareDocumentPosition(a, b);
      if (relative & DocumentPosition.PRECEDING) {
        return -1;
      } else if (relative & DocumentPosition.FOLLOWING) {
        return 1;
      }
      return 0;
    });
    return nodes;
  }
  function getFeed(doc) {
    const feedRoot = getOneElement(isValidFeed, doc);
    return !feedRoot ? null : feedRoot.name === "feed" ? getAtomFeed(feedRoot) : getRssFeed(feedRoot);
  }
  function getAtomFeed(feedRoot) {
    var _a2;
    const childs = feedRoot.children;
    const feed = {
      type: "atom",
      items: getElementsByTagName("entry", childs).map((item) => {
        var _a3;
        const { children } = item;
        const entry2 = { media: getMediaElements(children) };
        addConditionally(entry2, "id", "id", children);
        addConditionally(entry2, "title", "title", children);
        const href2 = (_a3 = getOneElement("link", children)) === null || _a3 === void 0 ? void 0 : _a3.attribs["href"];
        if (href2) {
          entry2.link = href2;
        }
        const description2 = fetch("summary", children) || fetch("content", children);
        if (description2) {
          entry2.description = description2;
        }
        const pubDate = fetch("updated", children);
        if (pubDate) {
          entry2.pubDate = new Date(pubDate);
        }
        return entry2;
      })
    };
    addConditionally(feed, "id", "id", childs);
    addConditionally(feed, "title", "title", childs);
    const href = (_a2 = getOneElement("link", childs)) === null || _a2 === void 0 ? void 0 : _a2.attribs["href"];
    if (href) {
      feed.link = href;
    }
    addConditionally(feed, "description", "subtitle", childs);
    const updated = fetch("updated", childs);
    if (updated) {
      feed.updated = new Date(updated);
    }
    addConditionally(feed, "author", "email", childs, true);
    return feed;
  }
  function getRssFeed(feedRoot) {
    var _a2, _b;
    const childs = (_b = (_a2 = getOneElement("channel", feedRoot.children)) === null || _a2 === void 0 ? void 0 : _a2.children) !== null && _b !== void 0 ? _b : [];
    const feed = {
      type: feedRoot.name.substr(0, 3),
      id: "",
      items: getElementsByTagName("item", feedRoot.children).map((item) => {
        const { children } = item;
        const entry2 = { media: getMediaElements(children) };
        addConditionally(entry2, "id", "guid", children);
        addConditionally(entry2, "title", "title", children);
        addConditionally(entry2, "link", "link", children);
        addConditionally(entry2, "description", "description", children);
        const pubDate = fetch("pubDate", children) || fetch("dc:date", children);
        if (pubDate)
          entry2.pubDate = new Date(pubDate);
        return entry2;
      })
    };
    addConditionally(feed, "title", "title", childs);
    addConditionally(feed, "link", "link", childs);
    addConditionally(feed, "description", "description", childs);
    const updated = fetch("lastBuildDate", childs);
    if (updated) {
      feed.updated = new Date(updated);
    }
    addConditionally(feed, "author", "managingEditor", childs, true);
    return feed;
  }
  var MEDIA_KEYS_STRING = ["url", "type", "lang"];
  var MEDIA_KEYS_INT = [
    "fileSize",
    "bitrate",
    "framerate",
    "samplingrate",
    "channels",
    "duration",
    "height",
    "width"
  ];
  function getMediaElements(where) {
    return getElementsByTagName("media:content", where).map((elem) => {
      const { attribs } = elem;
      const media = {
        medium: attribs["medium"],
        isDefault: !!attribs["isDefault"]
      };
      for (const attrib of MEDIA_KEYS_STRING) {
        if (attribs[attrib]) {
          media[attrib] = attribs[attrib];
        }
      }
      for (const attrib of MEDIA_KEYS_INT) {
        if (attribs[attrib]) {
          media[attrib] = parseInt(attribs[attrib], 10);
        }
      }
      if (attribs["expression"]) {
        media.expression = attribs["expression"];
      }
      return media;
    });
  }
  function getOneElement(tagName2, node) {
    return getElementsByTagName(tagName2, node, true, 1)[0];
  }
  function fetch(tagName2, where, recurse = false) {
    return textContent(getElementsByTagName(tagName2, where, recurse, 1)).trim();
  }
  function addConditionally(obj, prop2, tagName2, where, recurse = false) {
    const val = fetch(tagName2, where, recurse);
    if (val)
      obj[prop2] = val;
  }
  function isValidFeed(value) {
    return value === "rss" || value === "feed" || value === "rdf:RDF";
  }
  var DomUtils = /* @__PURE__ */ Object.freeze({
    __proto__: null,
    get DocumentPosition() {
      return DocumentPosition;
    },
    append: append$2,
    appendChild,
    compareDocumentPosition,
    existsOne: existsOne$1,
    filter,
    find,
    findAll: findAll$1,
    findOne: findOne$1,
    findOneChild,
    getAttributeValue: getAttributeValue$1,
    getChildren: getChildren$1,
    getElementById,
    getElements,
    getElementsByClassName,
    getElementsByTagName,
    getElementsByTagType,
    getFeed,
    getInnerHTML,
    getName: getName$1,
    getOuterHTML,
    getParent: getParent$1,
    getSiblings: getSiblings$1,
    getText: getText$1,
    hasAttrib: hasAttrib$1,
    hasChildren,
    innerText,
    isCDATA,
    isComment,
    isDocument,
    isTag: isTag$1,
    isText,
    nextElementSibling: nextElementSibling$1,
    prepend,
    prependChild,
    prevElementSibling,
    removeElement,
    removeSubsets: removeSubsets$1,
    replaceElement,
    testElement,
    textContent,
    uniqueSort
  });
  function parseDocument(data, options) {
    const handler2 = new DomHandler(void 0, options);
    new Parser$1(handler2, options).end(data);
    return handler2.root;
  }
  function parseDOM(data, options) {
    return parseDocument(data, options).children;
  }
  function createDocumentStream(callback, options, elementCallback) {
    const handler2 = new DomHandler((error) => callback(error, handler2.root), options, elementCallback);
    return new Parser$1(handler2, options);
  }
  function createDomStream(callback, options, elementCallback) {
    const handler2 = new DomHandler(callback, options, elementCallback);
    return new Parser$1(handler2, options);
  }
  var parseFeedDefaultOptions = { xmlMode: true };
  function parseFeed(feed, options = parseFeedDefaultOptions) {
    return getFeed(parseDOM(feed, options));
  }
  var HTMLParser2 = /* @__PURE__ */ Object.freeze({
    __proto__: null,
    DefaultHandler: DomHandler,
    DomHandler,
    DomUtils,
    ElementType: index,
    Parser: Parser$1,
    get QuoteType() {
      return QuoteType;
    },
    Tokenizer,
    createDocumentStream,
    createDomStream,
    getFeed,
    parseDOM,
    parseDocument,
    parseFeed
  });
  var NODE_END = -1;
  var ELEMENT_NODE = 1;
  var ATTRIBUTE_NODE = 2;
  var TEXT_NODE = 3;
  var CDATA_SECTION_NODE = 4;
  var COMMENT_NODE = 8;
  var DOCUMENT_NODE = 9;
  var DOCUMENT_TYPE_NODE = 10;
  var DOCUMENT_FRAGMENT_NODE = 11;
  var BLOCK_ELEMENTS = /* @__PURE__ */ new Set(["ARTICLE", "ASIDE", "BLOCKQUOTE", "BODY", "BR", "BUTTON", "CANVAS", "CAPTION", "COL", "COLGROUP", "DD", "DIV", "DL", "DT", "EMBED", "FIELDSET", "FIGCAPTION", "FIGURE", "FOOTER", "FORM", "H1", "H2", "H3", "H4", "H5", "H6", "LI", "UL", "OL", "P"]);
  var SHOW_ALL = -1;
  var SHOW_ELEMENT = 1;
  var SHOW_TEXT = 4;
  var SHOW_CDATA_SECTION = 8;
  var SHOW_COMMENT = 128;
  var DOCUMENT_POSITION_DISCONNECTED = 1;
  var DOCUMENT_POSITION_PRECEDING = 2;
  var DOCUMENT_POSITION_FOLLOWING = 4;
  var DOCUMENT_POSITION_CONTAINS = 8;
  var DOCUMENT_POSITION_CONTAINED_BY = 16;
  var DOCUMENT_POSITION_IMPLEMENTATION_SPECIFIC = 32;
  var SVG_NAMESPACE = "http://www.w3.org/2000/svg";
  var {
    assign,
    create: create$1,
    defineProperties,
    entries,
    keys,
    setPrototypeOf
  } = Object;
  var $String = String;
  var getEnd = (node) => node.nodeType === ELEMENT_NODE ? node[END] : node;
  var ignoreCase = ({ ownerDocument }) => ownerDocument[MIME].ignoreCase;
  var knownAdjacent = (prev, next) => {
    prev[NEXT] = next;
    next[PREV] = prev;
  };
  var knownBoundaries = (prev, current, next) => {
    knownAdjacent(prev, current);
    knownAdjacent(getEnd(current), next);
  };
  var knownSegment = (prev, start, end2, next) => {
    knownAdjacent(prev, start);
    knownAdjacent(getEnd(end2), next);
  };
  var knownSiblings = (prev, current, next) => {
    knownAdjacent(prev, current);
    knownAdjacent(current, next);
  };
  var localCase = ({ localName, ownerDocument }) => {
    return ownerDocument[MIME].ignoreCase ? localName.toUpperCase() : localName;
  };
  var setAdjacent = (prev, next) => {
    if (prev)
      prev[NEXT] = next;
    if (next)
      next[PREV] = prev;
  };
  var htmlToFragment = (ownerDocument, html3) => {
    const fragment = ownerDocument.createDocumentFragment();
    const elem = ownerDocument.createElement("");
    elem.innerHTML = html3;
    const { firstChild, lastChild } = elem;
    if (firstChild) {
      knownSegment(fragment, firstChild, lastChild, fragment[END]);
      let child = firstChild;
      do {
        child.parentNode = fragment;
      } while (child !== lastChild && (child = getEnd(child)[NEXT]));
    }
    return fragment;
  };
  var shadowRoots = /* @__PURE__ */ new WeakMap();
  var reactive = false;
  var Classes = /* @__PURE__ */ new WeakMap();
  var customElements = /* @__PURE__ */ new WeakMap();
  var attributeChangedCallback$1 = (element, attributeName, oldValue, newValue) => {
    if (reactive && customElements.has(element) && element.attributeChangedCallback && element.constructor.observedAttributes.includes(attributeName)) {
      element.attributeChangedCallback(attributeName, oldValue, newValue);
    }
  };
  var createTrigger = (method, isConnected2) => (element) => {
    if (customElements.has(element)) {
      const info = customElements.get(element);
      if (info.connected !== isConnected2 && element.isConnected === isConnected2) {
        info.connected = isConnected2;
        if (method in element)
          element[method]();
      }
    }
  };
  var triggerConnected = createTrigger("connectedCallback", true);
  var connectedCallback = (element) => {
    if (reactive) {
      triggerConnected(element);
      if (shadowRoots.has(element))
        element = shadowRoots.get(element).shadowRoot;
      let { [NEXT]: next, [END]: end2 } = element;
      while (next !== end2) {
        if (next.nodeType === ELEMENT_NODE)
          triggerConnected(next);
        next = next[NEXT];
      }
    }
  };
  var triggerDisconnected = createTrigger("disconnectedCallback", false);
  var disconnectedCallback = (element) => {
    if (reactive) {
      triggerDisconnected(element);
      if (shadowRoots.has(element))
        element = shadowRoots.get(element).shadowRoot;
      let { [NEXT]: next, [END]: end2 } = element;
      while (next !== end2) {
        if (next.nodeType === ELEMENT_NODE)
          triggerDisconnected(next);
        next = next[NEXT];
      }
    }
  };
  var CustomElementRegistry = class {
    /**
     * @param {Document} ownerDocument
     */
    constructor(ownerDocument) {
      this.ownerDocument = ownerDocument;
      this.registry = /* @__PURE__ */ new Map();
      this.waiting = /* @__PURE__ */ new Map();
      this.active = false;
    }
    /**
     * @param {string} localName the custom element definition name
     * @param {Function} Class the custom element **Class** definition
     * @param {object?} options the optional object with an `extends` property
     */
    define(localName, Class, options = {}) {
      const { ownerDocument, registry, waiting } = this;
      if (registry.has(localName))
        throw new Error("unable to redefine " + localName);
      if (Classes.has(Class))
        throw new Error("unable to redefine the same class: " + Class);
      this.active = reactive = true;
      const { extends: extend } = options;
      Classes.set(Class, {
        ownerDocument,
        options: { is: extend ? localName : "" },
        localName: extend || localName
      });
      const check = extend ? (element) => {
        return element.localName === extend && element.getAttribute("is") === localName;
      } : (element) => element.localName === localName;
      registry.set(localName, { Class, check });
      if (waiting.has(localName)) {
        for (const resolve of waiting.get(localName))
          resolve(Class);
        waiting.delete(localName);
      }
      ownerDocument.querySelectorAll(
        extend ? `${extend}[is="${localName}"]` : localName
      ).forEach(this.upgrade, this);
    }
    /**
     * @param {Element} element
     */
    upgrade(element) {
      if (customElements.has(element))
        return;
      const { ownerDocument, registry } = this;
      const ce = element.getAttribute("is") || element.localName;
      if (registry.has(ce)) {
        const { Class, check } = registry.get(ce);
        if (check(element)) {
          const { attributes: attributes2, isConnected: isConnected2 } = element;
          for (const attr of attributes2)
            element.removeAttributeNode(attr);
          const values = entries(element);
          for (const [key2] of values)
            delete element[key2];
          setPrototypeOf(element, Class.prototype);
          ownerDocument[UPGRADE] = { element, values };
          new Class(ownerDocument, ce);
          customElements.set(element, { connected: isConnected2 });
          for (const attr of attributes2)
            element.setAttributeNode(attr);
          if (isConnected2 && element.connectedCallback)
            element.connectedCallback();
        }
      }
    }
    /**
     * @param {string} localName the custom element definition name
     */
    whenDefined(localName) {
      const { registry, waiting } = this;
      return new Promise((resolve) => {
        if (registry.has(localName))
          resolve(registry.get(localName).Class);
        else {
          if (!waiting.has(localName))
            waiting.set(localName, []);
          waiting.get(localName).push(resolve);
        }
      });
    }
    /**
     * @param {string} localName the custom element definition name
     * @returns {Function?} the custom element **Class**, if any
     */
    get(localName) {
      const info = this.registry.get(localName);
      return info && info.Class;
    }
    /**
     * @param {Function} Class **Class** of custom element
     * @returns {string?} found tag name or null
     */
    getName(Class) {
      if (Classes.has(Class)) {
        const { localName } = Classes.get(Class);
        return localName;
      }
      return null;
    }
  };
  var { Parser: Parser2 } = HTMLParser2;
  var append$1 = (self, node, active) => {
    const end2 = self[END];
    node.parentNode = self;
    knownBoundaries(end2[PREV], node, end2);
    if (active && node.nodeType === ELEMENT_NODE)
      connectedCallback(node);
    return node;
  };
  var attribute = (element, end2, attribute2, value, active) => {
    attribute2[VALUE] = value;
    attribute2.ownerElement = element;
    knownSiblings(end2[PREV], attribute2, end2);
    if (attribute2.name === "class")
      element.className = value;
    if (active)
      attributeChangedCallback$1(element, attribute2.name, null, value);
  };
  var parseFromString = (document3, isHTML, markupLanguage) => {
    const { active, registry } = document3[CUSTOM_ELEMENTS];
    let node = document3;
    let ownerSVGElement = null;
    let parsingCData = false;
    const content = new Parser2({
      // <!DOCTYPE ...>
      onprocessinginstruction(name, data) {
        if (name.toLowerCase() === "!doctype")
          document3.doctype = data.slice(name.length).trim();
      },
      // <tagName>
      onopentag(name, attributes2) {
        let create2 = true;
        if (isHTML) {
          if (ownerSVGElement) {
            node = append$1(node, document3.createElementNS(SVG_NAMESPACE, name), active);
            node.ownerSVGElement = ownerSVGElement;
            create2 = false;
          } else if (name === "svg" || name === "SVG") {
            ownerSVGElement = document3.createElementNS(SVG_NAMESPACE, name);
            node = append$1(node, ownerSVGElement, active);
            create2 = false;
          } else if (active) {
            const ce = name.includes("-") ? name : attributes2.is || "";
            if (ce && registry.has(ce)) {
              const { Class } = registry.get(ce);
              node = append$1(node, new Class(), active);
              delete attributes2.is;
              create2 = false;
            }
          }
        }
        if (create2)
          node = append$1(node, document3.createElement(name), false);
        let end2 = node[END];
        for (const name2 of keys(attributes2))
          attribute(node, end2, document3.createAttribute(name2), attributes2[name2], active);
      },
      // #text, #comment
      oncomment(data) {
        append$1(node, document3.createComment(data), active);
      },
      ontext(text3) {
        if (parsingCData) {
          append$1(node, document3.createCDATASection(text3), active);
        } else {
          append$1(node, document3.createTextNode(text3), active);
        }
      },
      // #cdata
      oncdatastart() {
        parsingCData = true;
      },
      oncdataend() {
        parsingCData = false;
      },
      // </tagName>
      onclosetag() {
        if (isHTML && node === ownerSVGElement)
          ownerSVGElement = null;
        node = node.parentNode;
      }
    }, {
      lowerCaseAttributeNames: false,
      decodeEntities: true,
      xmlMode: !isHTML
    });
    content.write(markupLanguage);
    content.end();
    return document3;
  };
  var htmlClasses = /* @__PURE__ */ new Map();
  var registerHTMLClass = (names, Class) => {
    for (const name of [].concat(names)) {
      htmlClasses.set(name, Class);
      htmlClasses.set(name.toUpperCase(), Class);
    }
  };
  var loopSegment = ({ [NEXT]: next, [END]: end2 }, json) => {
    while (next !== end2) {
      switch (next.nodeType) {
        case ATTRIBUTE_NODE:
          attrAsJSON(next, json);
          break;
        case TEXT_NODE:
        case COMMENT_NODE:
        case CDATA_SECTION_NODE:
          characterDataAsJSON(next, json);
          break;
        case ELEMENT_NODE:
          elementAsJSON(next, json);
          next = getEnd(next);
          break;
        case DOCUMENT_TYPE_NODE:
          documentTypeAsJSON(next, json);
          break;
      }
      next = next[NEXT];
    }
    const last = json.length - 1;
    const value = json[last];
    if (typeof value === "number" && value < 0)
      json[last] += NODE_END;
    else
      json.push(NODE_END);
  };
  var attrAsJSON = (attr, json) => {
    json.push(ATTRIBUTE_NODE, attr.name);
    const value = attr[VALUE].trim();
    if (value)
      json.push(value);
  };
  var characterDataAsJSON = (node, json) => {
    const value = node[VALUE];
    if (value.trim())
      json.push(node.nodeType, value);
  };
  var nonElementAsJSON = (node, json) => {
    json.push(node.nodeType);
    loopSegment(node, json);
  };
  var documentTypeAsJSON = ({ name, publicId, systemId }, json) => {
    json.push(DOCUMENT_TYPE_NODE, name);
    if (publicId)
      json.push(publicId);
    if (systemId)
      json.push(systemId);
  };
  var elementAsJSON = (element, json) => {
    json.push(ELEMENT_NODE, element.localName);
    loopSegment(element, json);
  };
  var createRecord = (type, target, element, addedNodes, removedNodes, attributeName, oldValue) => ({
    type,
    target,
    addedNodes,
    removedNodes,
    attributeName,
    oldValue,
    previousSibling: element?.previousSibling || null,
    nextSibling: element?.nextSibling || null
  });
  var queueAttribute = (observer, target, attributeName, attributeFilter, attributeOldValue, oldValue) => {
    if (!attributeFilter || attributeFilter.includes(attributeName)) {
      const { callback, records, scheduled } = observer;
      records.push(createRecord(
        "attributes",
        target,
        null,
        [],
        [],
        attributeName,
        attributeOldValue ? oldValue : void 0
      ));
      if (!scheduled) {
        observer.scheduled = true;
        Promise.resolve().then(() => {
          observer.scheduled = false;
          callback(records.splice(0), observer);
        });
      }
    }
  };
  var attributeChangedCallback = (element, attributeName, oldValue) => {
    const { ownerDocument } = element;
    const { active, observers } = ownerDocument[MUTATION_OBSERVER];
    if (active) {
      for (const observer of observers) {
        for (const [
          target,
          {
            childList,
            subtree,
            attributes: attributes2,
            attributeFilter,
            attributeOldValue
          }
        ] of observer.nodes) {
          if (childList) {
            if (subtree && (target === ownerDocument || target.contains(element)) || !subtree && target.children.includes(element)) {
              queueAttribute(
                observer,
                element,
                attributeName,
                attributeFilter,
                attributeOldValue,
                oldValue
              );
              break;
            }
          } else if (attributes2 && target === element) {
            queueAttribute(
              observer,
              element,
              attributeName,
              attributeFilter,
              attributeOldValue,
              oldValue
            );
            break;
          }
        }
      }
    }
  };
  var moCallback = (element, parentNode) => {
    const { ownerDocument } = element;
    const { active, observers } = ownerDocument[MUTATION_OBSERVER];
    if (active) {
      for (const observer of observers) {
        for (const [target, { subtree, childList, characterData }] of observer.nodes) {
          if (childList) {
            if (parentNode && (target === parentNode || /* c8 ignore next */
            subtree && target.contains(parentNode)) || !parentNode && (subtree && (target === ownerDocument || /* c8 ignore next */
            target.contains(element)) || !subtree && target[characterData ? "childNodes" : "children"].includes(element))) {
              const { callback, records, scheduled } = observer;
              records.push(createRecord(
                "childList",
                target,
                element,
                parentNode ? [] : [element],
                parentNode ? [element] : []
              ));
              if (!scheduled) {
                observer.scheduled = true;
                Promise.resolve().then(() => {
                  observer.scheduled = false;
                  callback(records.splice(0), observer);
                });
              }
              break;
            }
          }
        }
      }
    }
  };
  var MutationObserverClass = class {
    constructor(ownerDocument) {
      const observers = /* @__PURE__ */ new Set();
      this.observers = observers;
      this.active = false;
      this.class = class MutationObserver {
        constructor(callback) {
          this.callback = callback;
          this.nodes = /* @__PURE__ */ new Map();
          this.records = [];
          this.scheduled = false;
        }
        disconnect() {
          this.records.splice(0);
          this.nodes.clear();
          observers.delete(this);
          ownerDocument[MUTATION_OBSERVER].active = !!observers.size;
        }
        /**
         * @param {Element} target
         * @param {MutationObserverInit} options
         */
        observe(target, options = {
          subtree: false,
          childList: false,
          attributes: false,
          attributeFilter: null,
          attributeOldValue: false,
          characterData: false
          // TODO: not implemented yet
          // characterDataOldValue: false
        }) {
          if ("attributeOldValue" in options || "attributeFilter" in options)
            options.attributes = true;
          options.childList = !!options.childList;
          options.subtree = !!options.subtree;
          this.nodes.set(target, options);
          observers.add(this);
          ownerDocument[MUTATION_OBSERVER].active = true;
        }
        /**
         * @returns {MutationRecord[]}
         */
        takeRecords() {
          return this.records.splice(0);
        }
      };
    }
  };
  var emptyAttributes = /* @__PURE__ */ new Set([
    "allowfullscreen",
    "allowpaymentrequest",
    "async",
    "autofocus",
    "autoplay",
    "checked",
    "class",
    "contenteditable",
    "controls",
    "default",
    "defer",
    "disabled",
    "draggable",
    "formnovalidate",
    "hidden",
    "id",
    "ismap",
    "itemscope",
    "loop",
    "multiple",
    "muted",
    "nomodule",
    "novalidate",
    "open",
    "playsinline",
    "readonly",
    "required",
    "reversed",
    "selected",
    "style",
    "truespeed"
  ]);
  var setAttribute = (element, attribute2) => {
    const { [VALUE]: value, name } = attribute2;
    attribute2.ownerElement = element;
    knownSiblings(element, attribute2, element[NEXT]);
    if (name === "class")
      element.className = value;
    attributeChangedCallback(element, name, null);
    attributeChangedCallback$1(element, name, null, value);
  };
  var removeAttribute = (element, attribute2) => {
    const { [VALUE]: value, name } = attribute2;
    knownAdjacent(attribute2[PREV], attribute2[NEXT]);
    attribute2.ownerElement = attribute2[PREV] = attribute2[NEXT] = null;
    if (name === "class")
      element[CLASS_LIST] = null;
    attributeChangedCallback(element, name, value);
    attributeChangedCallback$1(element, name, value, null);
  };
  var booleanAttribute = {
    get(element, name) {
      return element.hasAttribute(name);
    },
    set(element, name, value) {
      if (value)
        element.setAttribute(name, "");
      else
        element.removeAttribute(name);
    }
  };
  var numericAttribute = {
    get(element, name) {
      return parseFloat(element.getAttribute(name) || 0);
    },
    set(element, name, value) {
      element.setAttribute(name, value);
    }
  };
  var stringAttribute = {
    get(element, name) {
      return element.getAttribute(name) || "";
    },
    set(element, name, value) {
      element.setAttribute(name, value);
    }
  };
  var wm = /* @__PURE__ */ new WeakMap();
  function dispatch(event, listener) {
    if (typeof listener === "function")
      listener.call(event.target, event);
    else
      listener.handleEvent(event);
    return event._stopImmediatePropagationFlag;
  }
  function invokeListeners({ currentTarget, target }) {
    const map = wm.get(currentTarget);
    if (map && map.has(this.type)) {
      const listeners = map.get(this.type);
      if (currentTarget === target) {
        this.eventPhase = this.AT_TARGET;
      } else {
        this.eventPhase = this.BUBBLING_PHASE;
      }
      this.currentTarget = currentTarget;
      this.target = target;
      for (const [listener, options] of listeners) {
        if (options && options.once)
          listeners.delete(listener);
        if (dispatch(this, listener))
          break;
      }
      delete this.currentTarget;
      delete this.target;
      return this.cancelBubble;
    }
  }
  var DOMEventTarget = class {
    constructor() {
    }
    /**
     * @protected
     */
    _getParent() {
      return null;
    }
    addEventListener() {
    }
    _listen(type, listener, options) {
      const map = wm.get(this);
      if (!map.has(type))
        map.set(type, /* @__PURE__ */ new Map());
      map.get(type).set(listener, options);
    }
    removeEventListener(type, listener) {
      const map = wm.get(this);
      if (map.has(type)) {
        const listeners = map.get(type);
        if (listeners.delete(listener) && !listeners.size)
          map.delete(type);
      }
    }
    dispatchEvent(event) {
      let node = this;
      event.eventPhase = event.CAPTURING_PHASE;
      while (node) {
        if (node.dispatchEvent)
          event._path.push({ currentTarget: node, target: this });
        node = event.bubbles && node._getParent && node._getParent();
      }
      event._path.some(invokeListeners, event);
      event._path = [];
      event.eventPhase = event.NONE;
      return !event.defaultPrevented;
    }
  };
  var NodeList = class extends Array {
    item(i) {
      return i < this.length ? this[i] : null;
    }
  };
  var getParentNodeCount = ({ parentNode }) => {
    let count = 0;
    while (parentNode) {
      count++;
      parentNode = parentNode.parentNode;
    }
    return count;
  };
  var Node$1 = class Node2 extends DOMEventTarget {
    static get ELEMENT_NODE() {
      return ELEMENT_NODE;
    }
    static get ATTRIBUTE_NODE() {
      return ATTRIBUTE_NODE;
    }
    static get TEXT_NODE() {
      return TEXT_NODE;
    }
    static get CDATA_SECTION_NODE() {
      return CDATA_SECTION_NODE;
    }
    static get COMMENT_NODE() {
      return COMMENT_NODE;
    }
    static get DOCUMENT_NODE() {
      return DOCUMENT_NODE;
    }
    static get DOCUMENT_FRAGMENT_NODE() {
      return DOCUMENT_FRAGMENT_NODE;
    }
    static get DOCUMENT_TYPE_NODE() {
      return DOCUMENT_TYPE_NODE;
    }
    constructor(ownerDocument, localName, nodeType) {
      super();
      this.ownerDocument = ownerDocument;
      this.localName = localName;
      this.nodeType = nodeType;
      this.parentNode = null;
      this[NEXT] = null;
      this[PREV] = null;
    }
    get ELEMENT_NODE() {
      return ELEMENT_NODE;
    }
    get ATTRIBUTE_NODE() {
      return ATTRIBUTE_NODE;
    }
    get TEXT_NODE() {
      return TEXT_NODE;
    }
    get CDATA_SECTION_NODE() {
      return CDATA_SECTION_NODE;
    }
    get COMMENT_NODE() {
      return COMMENT_NODE;
    }
    get DOCUMENT_NODE() {
      return DOCUMENT_NODE;
    }
    get DOCUMENT_FRAGMENT_NODE() {
      return DOCUMENT_FRAGMENT_NODE;
    }
    get DOCUMENT_TYPE_NODE() {
      return DOCUMENT_TYPE_NODE;
    }
    get baseURI() {
      const ownerDocument = this.nodeType === DOCUMENT_NODE ? this : this.ownerDocument;
      if (ownerDocument) {
        const base = ownerDocument.querySelector("base");
        if (base)
          return base.getAttribute("href");
        const { location } = ownerDocument.defaultView;
        if (location)
          return location.href;
      }
      return null;
    }
    /* c8 ignore start */
    // mixin: node
    get isConnected() {
      return false;
    }
    get nodeName() {
      return this.localName;
    }
    get parentElement() {
      return null;
    }
    get previousSibling() {
      return null;
    }
    get previousElementSibling() {
      return null;
    }
    get nextSibling() {
      return null;
    }
    get nextElementSibling() {
      return null;
    }
    get childNodes() {
      return new NodeList();
    }
    get firstChild() {
      return null;
    }
    get lastChild() {
      return null;
    }
    // default values
    get nodeValue() {
      return null;
    }
    set nodeValue(value) {
    }
    get textContent() {
      return null;
    }
    set textContent(value) {
    }
    normalize() {
    }
    cloneNode() {
      return null;
    }
    contains() {
      return false;
    }
    /**
     * Inserts a node before a reference node as a child of this parent node.
     * @param {Node} newNode The node to be inserted.
     * @param {Node} referenceNode The node before which newNode is inserted. If this is null, then newNode is inserted at the end of node's child nodes.
     * @returns The added child
     */
    // eslint-disable-next-line no-unused-vars
    insertBefore(newNode, referenceNode) {
      return newNode;
    }
    /**
     * Adds a node to the end of the list of children of this node.
     * @param {Node} child The node to append to the given parent node.
     * @returns The appended child.
     */
    appendChild(child) {
      return child;
    }
    /**
     * Replaces a child node within this node
     * @param {Node} newChild The new node to replace oldChild.
     * @param {Node} oldChild The child to be replaced.
     * @returns The replaced Node. This is the same node as oldChild.
     */
    replaceChild(newChild, oldChild) {
      return oldChild;
    }
    /**
     * Removes a child node from the DOM.
     * @param {Node} child A Node that is the child node to be removed from the DOM.
     * @returns The removed node.
     */
    removeChild(child) {
      return child;
    }
    toString() {
      return "";
    }
    /* c8 ignore stop */
    hasChildNodes() {
      return !!this.lastChild;
    }
    isSameNode(node) {
      return this === node;
    }
    // TODO: attributes?
    compareDocumentPosition(target) {
      let result = 0;
      if (this !== target) {
        let self = getParentNodeCount(this);
        let other = getParentNodeCount(target);
        if (self < other) {
          result += DOCUMENT_POSITION_FOLLOWING;
          if (this.contains(target))
            result += DOCUMENT_POSITION_CONTAINED_BY;
        } else if (other < self) {
          result += DOCUMENT_POSITION_PRECEDING;
          if (target.contains(this))
            result += DOCUMENT_POSITION_CONTAINS;
        } else if (self && other) {
          const { childNodes } = this.parentNode;
          if (childNodes.indexOf(this) < childNodes.indexOf(target))
            result += DOCUMENT_POSITION_FOLLOWING;
          else
            result += DOCUMENT_POSITION_PRECEDING;
        }
        if (!self || !other) {
          result += DOCUMENT_POSITION_IMPLEMENTATION_SPECIFIC;
          result += DOCUMENT_POSITION_DISCONNECTED;
        }
      }
      return result;
    }
    isEqualNode(node) {
      if (this === node)
        return true;
      if (this.nodeType === node.nodeType) {
        switch (this.nodeType) {
          case DOCUMENT_NODE:
          case DOCUMENT_FRAGMENT_NODE: {
            const aNodes = this.childNodes;
            const bNodes = node.childNodes;
            return aNodes.length === bNodes.length && aNodes.every((node2, i) => node2.isEqualNode(bNodes[i]));
          }
        }
        return this.toString() === node.toString();
      }
      return false;
    }
    /**
     * @protected
     */
    _getParent() {
      return this.parentNode;
    }
    /**
     * Calling it on an element inside a standard web page will return an HTMLDocument object representing the entire page (or <iframe>).
     * Calling it on an element inside a shadow DOM will return the associated ShadowRoot.
     * @return {ShadowRoot | HTMLDocument}
     */
    getRootNode() {
      let root = this;
      while (root.parentNode)
        root = root.parentNode;
      return root;
    }
  };
  var { replace } = "";
  var ca = /[<>&\xA0]/g;
  var esca = {
    " ": "&#160;",
    "&": "&amp;",
    "<": "&lt;",
    ">": "&gt;"
  };
  var pe = (m) => esca[m];
  var escape = (es) => replace.call(es, ca, pe);
  var QUOTE = /"/g;
  var Attr$1 = class Attr extends Node$1 {
    constructor(ownerDocument, name, value = "") {
      super(ownerDocument, name, ATTRIBUTE_NODE);
      this.ownerElement = null;
      this.name = $String(name);
      this[VALUE] = $String(value);
      this[CHANGED] = false;
    }
    get value() {
      return this[VALUE];
    }
    set value(newValue) {
      const { [VALUE]: oldValue, name, ownerElement } = this;
      this[VALUE] = $String(newValue);
      this[CHANGED] = true;
      if (ownerElement) {
        attributeChangedCallback(ownerElement, name, oldValue);
        attributeChangedCallback$1(ownerElement, name, oldValue, this[VALUE]);
      }
    }
    cloneNode() {
      const { ownerDocument, name, [VALUE]: value } = this;
      return new Attr(ownerDocument, name, value);
    }
    toString() {
      const { name, [VALUE]: value } = this;
      if (emptyAttributes.has(name) && !value) {
        return ignoreCase(this) ? name : `${name}=""`;
      }
      const escapedValue = (ignoreCase(this) ? value : escape(value)).replace(QUOTE, "&quot;");
      return `${name}="${escapedValue}"`;
    }
    toJSON() {
      const json = [];
      attrAsJSON(this, json);
      return json;
    }
  };
  var isConnected = ({ ownerDocument, parentNode }) => {
    while (parentNode) {
      if (parentNode === ownerDocument)
        return true;
      parentNode = parentNode.parentNode || parentNode.host;
    }
    return false;
  };
  var parentElement = ({ parentNode }) => {
    if (parentNode) {
      switch (parentNode.nodeType) {
        case DOCUMENT_NODE:
        case DOCUMENT_FRAGMENT_NODE:
          return null;
      }
    }
    return parentNode;
  };
  var previousSibling = ({ [PREV]: prev }) => {
    switch (prev ? prev.nodeType : 0) {
      case NODE_END:
        return prev[START];
      case TEXT_NODE:
      case COMMENT_NODE:
      case CDATA_SECTION_NODE:
        return prev;
    }
    return null;
  };
  var nextSibling = (node) => {
    const next = getEnd(node)[NEXT];
    return next && (next.nodeType === NODE_END ? null : next);
  };
  var nextElementSibling = (node) => {
    let next = nextSibling(node);
    while (next && next.nodeType !== ELEMENT_NODE)
      next = nextSibling(next);
    return next;
  };
  var previousElementSibling = (node) => {
    let prev = previousSibling(node);
    while (prev && prev.nodeType !== ELEMENT_NODE)
      prev = previousSibling(prev);
    return prev;
  };
  var asFragment = (ownerDocument, nodes) => {
    const fragment = ownerDocument.createDocumentFragment();
    fragment.append(...nodes);
    return fragment;
  };
  var before = (node, nodes) => {
    const { ownerDocument, parentNode } = node;
    if (parentNode)
      parentNode.insertBefore(
        asFragment(ownerDocument, nodes),
        node
      );
  };
  var after = (node, nodes) => {
    const { ownerDocument, parentNode } = node;
    if (parentNode)
      parentNode.insertBefore(
        asFragment(ownerDocument, nodes),
        getEnd(node)[NEXT]
      );
  };
  var replaceWith = (node, nodes) => {
    const { ownerDocument, parentNode } = node;
    if (parentNode) {
      if (nodes.includes(node))
        replaceWith(node, [node = node.cloneNode()]);
      parentNode.insertBefore(
        asFragment(ownerDocument, nodes),
        node
      );
      node.remove();
    }
  };
  var remove = (prev, current, next) => {
    const { parentNode, nodeType } = current;
    if (prev || next) {
      setAdjacent(prev, next);
      current[PREV] = null;
      getEnd(current)[NEXT] = null;
    }
    if (parentNode) {
      current.parentNode = null;
      moCallback(current, parentNode);
      if (nodeType === ELEMENT_NODE)
        disconnectedCallback(current);
    }
  };
  var CharacterData$1 = class CharacterData extends Node$1 {
    constructor(ownerDocument, localName, nodeType, data) {
      super(ownerDocument, localName, nodeType);
      this[VALUE] = $String(data);
    }
    // <Mixins>
    get isConnected() {
      return isConnected(this);
    }
    get parentElement() {
      return parentElement(this);
    }
    get previousSibling() {
      return previousSibling(this);
    }
    get nextSibling() {
      return nextSibling(this);
    }
    get previousElementSibling() {
      return previousElementSibling(this);
    }
    get nextElementSibling() {
      return nextElementSibling(this);
    }
    before(...nodes) {
      before(this, nodes);
    }
    after(...nodes) {
      after(this, nodes);
    }
    replaceWith(...nodes) {
      replaceWith(this, nodes);
    }
    remove() {
      remove(this[PREV], this, this[NEXT]);
    }
    // </Mixins>
    // CharacterData only
    /* c8 ignore start */
    get data() {
      return this[VALUE];
    }
    set data(value) {
      this[VALUE] = $String(value);
      moCallback(this, this.parentNode);
    }
    get nodeValue() {
      return this.data;
    }
    set nodeValue(value) {
      this.data = value;
    }
    get textContent() {
      return this.data;
    }
    set textContent(value) {
      this.data = value;
    }
    get length() {
      return this.data.length;
    }
    substringData(offset, count) {
      return this.data.substr(offset, count);
    }
    appendData(data) {
      this.data += data;
    }
    insertData(offset, data) {
      const { data: t } = this;
      this.data = t.slice(0, offset) + data + t.slice(offset);
    }
    deleteData(offset, count) {
      const { data: t } = this;
      this.data = t.slice(0, offset) + t.slice(offset + count);
    }
    replaceData(offset, count, data) {
      const { data: t } = this;
      this.data = t.slice(0, offset) + data + t.slice(offset + count);
    }
    /* c8 ignore stop */
    toJSON() {
      const json = [];
      characterDataAsJSON(this, json);
      return json;
    }
  };
  var CDATASection$1 = class CDATASection extends CharacterData$1 {
    constructor(ownerDocument, data = "") {
      super(ownerDocument, "#cdatasection", CDATA_SECTION_NODE, data);
    }
    cloneNode() {
      const { ownerDocument, [VALUE]: data } = this;
      return new CDATASection(ownerDocument, data);
    }
    toString() {
      return `<![CDATA[${this[VALUE]}]]>`;
    }
  };
  var Comment$1 = class Comment2 extends CharacterData$1 {
    constructor(ownerDocument, data = "") {
      super(ownerDocument, "#comment", COMMENT_NODE, data);
    }
    cloneNode() {
      const { ownerDocument, [VALUE]: data } = this;
      return new Comment2(ownerDocument, data);
    }
    toString() {
      return `<!--${this[VALUE]}-->`;
    }
  };
  function getDefaultExportFromCjs(x) {
    return x && x.__esModule && Object.prototype.hasOwnProperty.call(x, "default") ? x["default"] : x;
  }
  var boolbase$1;
  var hasRequiredBoolbase;
  function requireBoolbase() {
    if (hasRequiredBoolbase) return boolbase$1;
    hasRequiredBoolbase = 1;
    boolbase$1 = {
      trueFunc: function trueFunc() {
        return true;
      },
      falseFunc: function falseFunc() {
        return false;
      }
    };
    return boolbase$1;
  }
  var boolbaseExports = requireBoolbase();
  var boolbase = /* @__PURE__ */ getDefaultExportFromCjs(boolbaseExports);
  var SelectorType;
  (function(SelectorType2) {
    SelectorType2["Attribute"] = "attribute";
    SelectorType2["Pseudo"] = "pseudo";
    SelectorType2["PseudoElement"] = "pseudo-element";
    SelectorType2["Tag"] = "tag";
    SelectorType2["Universal"] = "universal";
    SelectorType2["Adjacent"] = "adjacent";
    SelectorType2["Child"] = "child";
    SelectorType2["Descendant"] = "descendant";
    SelectorType2["Parent"] = "parent";
    SelectorType2["Sibling"] = "sibling";
    SelectorType2["ColumnCombinator"] = "column-combinator";
  })(SelectorType || (SelectorType = {}));
  var AttributeAction;
  (function(AttributeAction2) {
    AttributeAction2["Any"] = "any";
    AttributeAction2["Element"] = "element";
    AttributeAction2["End"] = "end";
    AttributeAction2["Equals"] = "equals";
    AttributeAction2["Exists"] = "exists";
    AttributeAction2["Hyphen"] = "hyphen";
    AttributeAction2["Not"] = "not";
    AttributeAction2["Start"] = "start";
  })(AttributeAction || (AttributeAction = {}));
  var reName = /^[^\\#]?(?:\\(?:[\da-f]{1,6}\s?|.)|[\w\-\u00b0-\uFFFF])+/;
  var reEscape = /\\([\da-f]{1,6}\s?|(\s)|.)/gi;
  var actionTypes = /* @__PURE__ */ new Map([
    [126, AttributeAction.Element],
    [94, AttributeAction.Start],
    [36, AttributeAction.End],
    [42, AttributeAction.Any],
    [33, AttributeAction.Not],
    [124, AttributeAction.Hyphen]
  ]);
  var unpackPseudos = /* @__PURE__ */ new Set([
    "has",
    "not",
    "matches",
    "is",
    "where",
    "host",
    "host-context"
  ]);
  function isTraversal$1(selector) {
    switch (selector.type) {
      case SelectorType.Adjacent:
      case SelectorType.Child:
      case SelectorType.Descendant:
      case SelectorType.Parent:
      case SelectorType.Sibling:
      case SelectorType.ColumnCombinator:
        return true;
      default:
        return false;
    }
  }
  var stripQuotesFromPseudos = /* @__PURE__ */ new Set(["contains", "icontains"]);
  function funescape(_, escaped, escapedWhitespace) {
    const high = parseInt(escaped, 16) - 65536;
    return high !== high || escapedWhitespace ? escaped : high < 0 ? (
      // BMP codepoint
      String.fromCharCode(high + 65536)
    ) : (
      // Supplemental Plane codepoint (surrogate pair)
      String.fromCharCode(high >> 10 | 55296, high & 1023 | 56320)
    );
  }
  function unescapeCSS(str) {
    return str.replace(reEscape, funescape);
  }
  function isQuote(c) {
    return c === 39 || c === 34;
  }
  function isWhitespace(c) {
    return c === 32 || c === 9 || c === 10 || c === 12 || c === 13;
  }
  function parse$3(selector) {
    const subselects2 = [];
    const endIndex = parseSelector(subselects2, `${selector}`, 0);
    if (endIndex < selector.length) {
      throw new Error(`Unmatched selector: ${selector.slice(endIndex)}`);
    }
    return subselects2;
  }
  function parseSelector(subselects2, selector, selectorIndex) {
    let tokens = [];
    function getName2(offset) {
      const match = selector.slice(selectorIndex + offset).match(reName);
      if (!match) {
        throw new Error(`Expected name, found ${selector.slice(selectorIndex)}`);
      }
      const [name] = match;
      selectorIndex += offset + name.length;
      return unescapeCSS(name);
    }
    function stripWhitespace(offset) {
      selectorIndex += offset;
      while (selectorIndex < selector.length && isWhitespace(selector.charCodeAt(selectorIndex))) {
        selectorIndex++;
      }
    }
    function readValueWithParenthesis() {
      selectorIndex += 1;
      const start = selectorIndex;
      let counter = 1;
      for (; counter > 0 && selectorIndex < selector.length; selectorIndex++) {
        if (selector.charCodeAt(selectorIndex) === 40 && !isEscaped(selectorIndex)) {
          counter++;
        } else if (selector.charCodeAt(selectorIndex) === 41 && !isEscaped(selectorIndex)) {
          counter--;
        }
      }
      if (counter) {
        throw new Error("Parenthesis not matched");
      }
      return unescapeCSS(selector.slice(start, selectorIndex - 1));
    }
    function isEscaped(pos) {
      let slashCount = 0;
      while (selector.charCodeAt(--pos) === 92)
        slashCount++;
      return (slashCount & 1) === 1;
    }
    function ensureNotTraversal() {
      if (tokens.length > 0 && isTraversal$1(tokens[tokens.length - 1])) {
        throw new Error("Did not expect successive traversals.");
      }
    }
    function addTraversal(type) {
      if (tokens.length > 0 && tokens[tokens.length - 1].type === SelectorType.Descendant) {
        tokens[tokens.length - 1].type = type;
        return;
      }
      ensureNotTraversal();
      tokens.push({ type });
    }
    function addSpecialAttribute(name, action) {
      tokens.push({
        type: SelectorType.Attribute,
        name,
        action,
        value: getName2(1),
        namespace: null,
        ignoreCase: "quirks"
      });
    }
    function finalizeSubselector() {
      if (tokens.length && tokens[tokens.length - 1].type === SelectorType.Descendant) {
        tokens.pop();
      }
      if (tokens.length === 0) {
        throw new Error("Empty sub-selector");
      }
      subselects2.push(tokens);
    }
    stripWhitespace(0);
    if (selector.length === selectorIndex) {
      return selectorIndex;
    }
    loop: while (selectorIndex < selector.length) {
      const firstChar = selector.charCodeAt(selectorIndex);
      switch (firstChar) {
        // Whitespace
        case 32:
        case 9:
        case 10:
        case 12:
        case 13: {
          if (tokens.length === 0 || tokens[0].type !== SelectorType.Descendant) {
            ensureNotTraversal();
            tokens.push({ type: SelectorType.Descendant });
          }
          stripWhitespace(1);
          break;
        }
        // Traversals
        case 62: {
          addTraversal(SelectorType.Child);
          stripWhitespace(1);
          break;
        }
        case 60: {
          addTraversal(SelectorType.Parent);
          stripWhitespace(1);
          break;
        }
        case 126: {
          addTraversal(SelectorType.Sibling);
          stripWhitespace(1);
          break;
        }
        case 43: {
          addTraversal(SelectorType.Adjacent);
          stripWhitespace(1);
          break;
        }
        // Special attribute selectors: .class, #id
        case 46: {
          addSpecialAttribute("class", AttributeAction.Element);
          break;
        }
        case 35: {
          addSpecialAttribute("id", AttributeAction.Equals);
          break;
        }
        case 91: {
          stripWhitespace(1);
          let name;
          let namespace = null;
          if (selector.charCodeAt(selectorIndex) === 124) {
            name = getName2(1);
          } else if (selector.startsWith("*|", selectorIndex)) {
            namespace = "*";
            name = getName2(2);
          } else {
            name = getName2(0);
            if (selector.charCodeAt(selectorIndex) === 124 && selector.charCodeAt(selectorIndex + 1) !== 61) {
              namespace = name;
              name = getName2(1);
            }
          }
          stripWhitespace(0);
          let action = AttributeAction.Exists;
          const possibleAction = actionTypes.get(selector.charCodeAt(selectorIndex));
          if (possibleAction) {
            action = possibleAction;
            if (selector.charCodeAt(selectorIndex + 1) !== 61) {
              throw new Error("Expected `=`");
            }
            stripWhitespace(2);
          } else if (selector.charCodeAt(selectorIndex) === 61) {
            action = AttributeAction.Equals;
            stripWhitespace(1);
          }
          let value = "";
          let ignoreCase2 = null;
          if (action !== "exists") {
            if (isQuote(selector.charCodeAt(selectorIndex))) {
              const quote = selector.charCodeAt(selectorIndex);
              let sectionEnd = selectorIndex + 1;
              while (sectionEnd < selector.length && (selector.charCodeAt(sectionEnd) !== quote || isEscaped(sectionEnd))) {
                sectionEnd += 1;
              }
              if (selector.charCodeAt(sectionEnd) !== quote) {
                throw new Error("Attribute value didn't end");
              }
              value = unescapeCSS(selector.slice(selectorIndex + 1, sectionEnd));
              selectorIndex = sectionEnd + 1;
            } else {
              const valueStart = selectorIndex;
              while (selectorIndex < selector.length && (!isWhitespace(selector.charCodeAt(selectorIndex)) && selector.charCodeAt(selectorIndex) !== 93 || isEscaped(selectorIndex))) {
                selectorIndex += 1;
              }
              value = unescapeCSS(selector.slice(valueStart, selectorIndex));
            }
            stripWhitespace(0);
            const forceIgnore = selector.charCodeAt(selectorIndex) | 32;
            if (forceIgnore === 115) {
              ignoreCase2 = false;
              stripWhitespace(1);
            } else if (forceIgnore === 105) {
              ignoreCase2 = true;
              stripWhitespace(1);
            }
          }
          if (selector.charCodeAt(selectorIndex) !== 93) {
            throw new Error("Attribute selector didn't terminate");
          }
          selectorIndex += 1;
          const attributeSelector = {
            type: SelectorType.Attribute,
            name,
            action,
            value,
            namespace,
            ignoreCase: ignoreCase2
          };
          tokens.push(attributeSelector);
          break;
        }
        case 58: {
          if (selector.charCodeAt(selectorIndex + 1) === 58) {
            tokens.push({
              type: SelectorType.PseudoElement,
              name: getName2(2).toLowerCase(),
              data: selector.charCodeAt(selectorIndex) === 40 ? readValueWithParenthesis() : null
            });
            continue;
          }
          const name = getName2(1).toLowerCase();
          let data = null;
          if (selector.charCodeAt(selectorIndex) === 40) {
            if (unpackPseudos.has(name)) {
              if (isQuote(selector.charCodeAt(selectorIndex + 1))) {
                throw new Error(`Pseudo-selector ${name} cannot be quoted`);
              }
              data = [];
              selectorIndex = parseSelector(data, selector, selectorIndex + 1);
              if (selector.charCodeAt(selectorIndex) !== 41) {
                throw new Error(`Missing closing parenthesis in :${name} (${selector})`);
              }
              selectorIndex += 1;
            } else {
              data = readValueWithParenthesis();
              if (stripQuotesFromPseudos.has(name)) {
                const quot = data.charCodeAt(0);
                if (quot === data.charCodeAt(data.length - 1) && isQuote(quot)) {
                  data = data.slice(1, -1);
                }
              }
              data = unescapeCSS(data);
            }
          }
          tokens.push({ type: SelectorType.Pseudo, name, data });
          break;
        }
        case 44: {
          finalizeSubselector();
          tokens = [];
          stripWhitespace(1);
          break;
        }
        default: {
          if (selector.startsWith("/*", selectorIndex)) {
            const endIndex = selector.indexOf("*/", selectorIndex + 2);
            if (endIndex < 0) {
              throw new Error("Comment was not terminated");
            }
            selectorIndex = endIndex + 2;
            if (tokens.length === 0) {
              stripWhitespace(0);
            }
            break;
          }
          let namespace = null;
          let name;
          if (firstChar === 42) {
            selectorIndex += 1;
            name = "*";
          } else if (firstChar === 124) {
            name = "";
            if (selector.charCodeAt(selectorIndex + 1) === 124) {
              addTraversal(SelectorType.ColumnCombinator);
              stripWhitespace(2);
              break;
            }
          } else if (reName.test(selector.slice(selectorIndex))) {
            name = getName2(0);
          } else {
            break loop;
          }
          if (selector.charCodeAt(selectorIndex) === 124 && selector.charCodeAt(selectorIndex + 1) !== 124) {
            namespace = name;
            if (selector.charCodeAt(selectorIndex + 1) === 42) {
              name = "*";
              selectorIndex += 2;
            } else {
              name = getName2(1);
            }
          }
          tokens.push(name === "*" ? { type: SelectorType.Universal, namespace } : { type: SelectorType.Tag, name, namespace });
        }
      }
    }
    finalizeSubselector();
    return selectorIndex;
  }
  var procedure = /* @__PURE__ */ new Map([
    [SelectorType.Universal, 50],
    [SelectorType.Tag, 30],
    [SelectorType.Attribute, 1],
    [SelectorType.Pseudo, 0]
  ]);
  function isTraversal(token) {
    return !procedure.has(token.type);
  }
  var attributes = /* @__PURE__ */ new Map([
    [AttributeAction.Exists, 10],
    [AttributeAction.Equals, 8],
    [AttributeAction.Not, 7],
    [AttributeAction.Start, 6],
    [AttributeAction.End, 6],
    [AttributeAction.Any, 5]
  ]);
  function sortByProcedure(arr) {
    const procs = arr.map(getProcedure);
    for (let i = 1; i < arr.length; i++) {
      const procNew = procs[i];
      if (procNew < 0)
        continue;
      for (let j = i - 1; j >= 0 && procNew < procs[j]; j--) {
        const token = arr[j + 1];
        arr[j + 1] = arr[j];
        arr[j] = token;
        procs[j + 1] = procs[j];
        procs[j] = procNew;
      }
    }
  }
  function getProcedure(token) {
    var _a2, _b;
    let proc = (_a2 = procedure.get(token.type)) !== null && _a2 !== void 0 ? _a2 : -1;
    if (token.type === SelectorType.Attribute) {
      proc = (_b = attributes.get(token.action)) !== null && _b !== void 0 ? _b : 4;
      if (token.action === AttributeAction.Equals && token.name === "id") {
        proc = 9;
      }
      if (token.ignoreCase) {
        proc >>= 1;
      }
    } else if (token.type === SelectorType.Pseudo) {
      if (!token.data) {
        proc = 3;
      } else if (token.name === "has" || token.name === "contains") {
        proc = 0;
      } else if (Array.isArray(token.data)) {
        proc = Math.min(...token.data.map((d) => Math.min(...d.map(getProcedure))));
        if (proc < 0) {
          proc = 0;
        }
      } else {
        proc = 2;
      }
    }
    return proc;
  }
  var reChars = /[-[\]{}()*+?.,\\^$|#\s]/g;
  function escapeRegex(value) {
    return value.replace(reChars, "\\$&");
  }
  var caseInsensitiveAttributes = /* @__PURE__ */ new Set([
    "accept",
    "accept-charset",
    "align",
    "alink",
    "axis",
    "bgcolor",
    "charset",
    "checked",
    "clear",
    "codetype",
    "color",
    "compact",
    "declare",
    "defer",
    "dir",
    "direction",
    "disabled",
    "enctype",
    "face",
    "frame",
    "hreflang",
    "http-equiv",
    "lang",
    "language",
    "link",
    "media",
    "method",
    "multiple",
    "nohref",
    "noresize",
    "noshade",
    "nowrap",
    "readonly",
    "rel",
    "rev",
    "rules",
    "scope",
    "scrolling",
    "selected",
    "shape",
    "target",
    "text",
    "type",
    "valign",
    "valuetype",
    "vlink"
  ]);
  function shouldIgnoreCase(selector, options) {
    return typeof selector.ignoreCase === "boolean" ? selector.ignoreCase : selector.ignoreCase === "quirks" ? !!options.quirksMode : !options.xmlMode && caseInsensitiveAttributes.has(selector.name);
  }
  var attributeRules = {
    equals(next, data, options) {
      const { adapter: adapter2 } = options;
      const { name } = data;
      let { value } = data;
      if (shouldIgnoreCase(data, options)) {
        value = value.toLowerCase();
        return (elem) => {
          const attr = adapter2.getAttributeValue(elem, name);
          return attr != null && attr.length === value.length && attr.toLowerCase() === value && next(elem);
        };
      }
      return (elem) => adapter2.getAttributeValue(elem, name) === value && next(elem);
    },
    hyphen(next, data, options) {
      const { adapter: adapter2 } = options;
      const { name } = data;
      let { value } = data;
      const len = value.length;
      if (shouldIgnoreCase(data, options)) {
        value = value.toLowerCase();
        return function hyphenIC(elem) {
          const attr = adapter2.getAttributeValue(elem, name);
          return attr != null && (attr.length === len || attr.charAt(len) === "-") && attr.substr(0, len).toLowerCase() === value && next(elem);
        };
      }
      return function hyphen(elem) {
        const attr = adapter2.getAttributeValue(elem, name);
        return attr != null && (attr.length === len || attr.charAt(len) === "-") && attr.substr(0, len) === value && next(elem);
      };
    },
    element(next, data, options) {
      const { adapter: adapter2 } = options;
      const { name, value } = data;
      if (/\s/.test(value)) {
        return boolbase.falseFunc;
      }
      const regex = new RegExp(`(?:^|\\s)${escapeRegex(value)}(?:$|\\s)`, shouldIgnoreCase(data, options) ? "i" : "");
      return function element(elem) {
        const attr = adapter2.getAttributeValue(elem, name);
        return attr != null && attr.length >= value.length && regex.test(attr) && next(elem);
      };
    },
    exists(next, { name }, { adapter: adapter2 }) {
      return (elem) => adapter2.hasAttrib(elem, name) && next(elem);
    },
    start(next, data, options) {
      const { adapter: adapter2 } = options;
      const { name } = data;
      let { value } = data;
      const len = value.length;
      if (len === 0) {
        return boolbase.falseFunc;
      }
      if (shouldIgnoreCase(data, options)) {
        value = value.toLowerCase();
        return (elem) => {
          const attr = adapter2.getAttributeValue(elem, name);
          return attr != null && attr.length >= len && attr.substr(0, len).toLowerCase() === value && next(elem);
        };
      }
      return (elem) => {
        var _a2;
        return !!((_a2 = adapter2.getAttributeValue(elem, name)) === null || _a2 === void 0 ? void 0 : _a2.startsWith(value)) && next(elem);
      };
    },
    end(next, data, options) {
      const { adapter: adapter2 } = options;
      const { name } = data;
      let { value } = data;
      const len = -value.length;
      if (len === 0) {
        return boolbase.falseFunc;
      }
      if (shouldIgnoreCase(data, options)) {
        value = value.toLowerCase();
        return (elem) => {
          var _a2;
          return ((_a2 = adapter2.getAttributeValue(elem, name)) === null || _a2 === void 0 ? void 0 : _a2.substr(len).toLowerCase()) === value && next(elem);
        };
      }
      return (elem) => {
        var _a2;
        return !!((_a2 = adapter2.getAttributeValue(elem, name)) === null || _a2 === void 0 ? void 0 : _a2.endsWith(value)) && next(elem);
      };
    },
    any(next, data, options) {
      const { adapter: adapter2 } = options;
      const { name, value } = data;
      if (value === "") {
        return boolbase.falseFunc;
      }
      if (shouldIgnoreCase(data, options)) {
        const regex = new RegExp(escapeRegex(value), "i");
        return function anyIC(elem) {
          const attr = adapter2.getAttributeValue(elem, name);
          return attr != null && attr.length >= value.length && regex.test(attr) && next(elem);
        };
      }
      return (elem) => {
        var _a2;
        return !!((_a2 = adapter2.getAttributeValue(elem, name)) === null || _a2 === void 0 ? void 0 : _a2.includes(value)) && next(elem);
      };
    },
    not(next, data, options) {
      const { adapter: adapter2 } = options;
      const { name } = data;
      let { value } = data;
      if (value === "") {
        return (elem) => !!adapter2.getAttributeValue(elem, name) && next(elem);
      } else if (shouldIgnoreCase(data, options)) {
        value = value.toLowerCase();
        return (elem) => {
          const attr = adapter2.getAttributeValue(elem, name);
          return (attr == null || attr.length !== value.length || attr.toLowerCase() !== value) && next(elem);
        };
      }
      return (elem) => adapter2.getAttributeValue(elem, name) !== value && next(elem);
    }
  };
  var whitespace = /* @__PURE__ */ new Set([9, 10, 12, 13, 32]);
  var ZERO = "0".charCodeAt(0);
  var NINE = "9".charCodeAt(0);
  function parse$2(formula) {
    formula = formula.trim().toLowerCase();
    if (formula === "even") {
      return [2, 0];
    } else if (formula === "odd") {
      return [2, 1];
    }
    let idx = 0;
    let a = 0;
    let sign = readSign();
    let number = readNumber();
    if (idx < formula.length && formula.charAt(idx) === "n") {
      idx++;
      a = sign * (number !== null && number !== void 0 ? number : 1);
      skipWhitespace();
      if (idx < formula.length) {
        sign = readSign();
        skipWhitespace();
        number = readNumber();
      } else {
        sign = number = 0;
      }
    }
    if (number === null || idx < formula.length) {
      throw new Error(`n-th rule couldn't be parsed ('${formula}')`);
    }
    return [a, sign * number];
    function readSign() {
      if (formula.charAt(idx) === "-") {
        idx++;
        return -1;
      }
      if (formula.charAt(idx) === "+") {
        idx++;
      }
      return 1;
    }
    function readNumber() {
      const start = idx;
      let value = 0;
      while (idx < formula.length && formula.charCodeAt(idx) >= ZERO && formula.charCodeAt(idx) <= NINE) {
        value = value * 10 + (formula.charCodeAt(idx) - ZERO);
        idx++;
      }
      return idx === start ? null : value;
    }
    function skipWhitespace() {
      while (idx < formula.length && whitespace.has(formula.charCodeAt(idx))) {
        idx++;
      }
    }
  }
  function compile$2(parsed) {
    const a = parsed[0];
    const b = parsed[1] - 1;
    if (b < 0 && a <= 0)
      return boolbase.falseFunc;
    if (a === -1)
      return (index2) => index2 <= b;
    if (a === 0)
      return (index2) => index2 === b;
    if (a === 1)
      return b < 0 ? boolbase.trueFunc : (index2) => index2 >= b;
    const absA = Math.abs(a);
    const bMod = (b % absA + absA) % absA;
    return a > 1 ? (index2) => index2 >= b && index2 % absA === bMod : (index2) => index2 <= b && index2 % absA === bMod;
  }
  function nthCheck(formula) {
    return compile$2(parse$2(formula));
  }
  function getChildFunc(next, adapter2) {
    return (elem) => {
      const parent = adapter2.getParent(elem);
      return parent != null && adapter2.isTag(parent) && next(elem);
    };
  }
  var filters = {
    contains(next, text3, { adapter: adapter2 }) {
      return function contains(elem) {
        return next(elem) && adapter2.getText(elem).includes(text3);
      };
    },
    icontains(next, text3, { adapter: adapter2 }) {
      const itext = text3.toLowerCase();
      return function icontains(elem) {
        return next(elem) && adapter2.getText(elem).toLowerCase().includes(itext);
      };
    },
    // Location specific methods
    "nth-child"(next, rule, { adapter: adapter2, equals }) {
      const func = nthCheck(rule);
      if (func === boolbase.falseFunc)
        return boolbase.falseFunc;
      if (func === boolbase.trueFunc)
        return getChildFunc(next, adapter2);
      return function nthChild(elem) {
        const siblings = adapter2.getSiblings(elem);
        let pos = 0;
        for (let i = 0; i < siblings.length; i++) {
          if (equals(elem, siblings[i]))
            break;
          if (adapter2.isTag(siblings[i])) {
            pos++;
          }
        }
        return func(pos) && next(elem);
      };
    },
    "nth-last-child"(next, rule, { adapter: adapter2, equals }) {
      const func = nthCheck(rule);
      if (func === boolbase.falseFunc)
        return boolbase.falseFunc;
      if (func === boolbase.trueFunc)
        return getChildFunc(next, adapter2);
      return function nthLastChild(elem) {
        const siblings = adapter2.getSiblings(elem);
        let pos = 0;
        for (let i = siblings.length - 1; i >= 0; i--) {
          if (equals(elem, siblings[i]))
            break;
          if (adapter2.isTag(siblings[i])) {
            pos++;
          }
        }
        return func(pos) && next(elem);
      };
    },
    "nth-of-type"(next, rule, { adapter: adapter2, equals }) {
      const func = nthCheck(rule);
      if (func === boolbase.falseFunc)
        return boolbase.falseFunc;
      if (func === boolbase.trueFunc)
        return getChildFunc(next, adapter2);
      return function nthOfType(elem) {
        const siblings = adapter2.getSiblings(elem);
        let pos = 0;
        for (let i = 0; i < siblings.length; i++) {
          const currentSibling = siblings[i];
          if (equals(elem, currentSibling))
            break;
          if (adapter2.isTag(currentSibling) && adapter2.getName(currentSibling) === adapter2.getName(elem)) {
            pos++;
          }
        }
        return func(pos) && next(elem);
      };
    },
    "nth-last-of-type"(next, rule, { adapter: adapter2, equals }) {
      const func = nthCheck(rule);
      if (func === boolbase.falseFunc)
        return boolbase.falseFunc;
      if (func === boolbase.trueFunc)
        return getChildFunc(next, adapter2);
      return function nthLastOfType(elem) {
        const siblings = adapter2.getSiblings(elem);
        let pos = 0;
        for (let i = siblings.length - 1; i >= 0; i--) {
          const currentSibling = siblings[i];
          if (equals(elem, currentSibling))
            break;
          if (adapter2.isTag(currentSibling) && adapter2.getName(currentSibling) === adapter2.getName(elem)) {
            pos++;
          }
        }
        return func(pos) && next(elem);
      };
    },
    // TODO determine the actual root element
    root(next, _rule, { adapter: adapter2 }) {
      return (elem) => {
        const parent = adapter2.getParent(elem);
        return (parent == null || !adapter2.isTag(parent)) && next(elem);
      };
    },
    scope(next, rule, options, context) {
      const { equals } = options;
      if (!context || context.length === 0) {
        return filters["root"](next, rule, options);
      }
      if (context.length === 1) {
        return (elem) => equals(context[0], elem) && next(elem);
      }
      return (elem) => context.includes(elem) && next(elem);
    },
    hover: dynamicStatePseudo("isHovered"),
    visited: dynamicStatePseudo("isVisited"),
    active: dynamicStatePseudo("isActive")
  };
  function dynamicStatePseudo(name) {
    return function dynamicPseudo(next, _rule, { adapter: adapter2 }) {
      const func = adapter2[name];
      if (typeof func !== "function") {
        return boolbase.falseFunc;
      }
      return function active(elem) {
        return func(elem) && next(elem);
      };
    };
  }
  var pseudos = {
    empty(elem, { adapter: adapter2 }) {
      return !adapter2.getChildren(elem).some((elem2) => (
        // FIXME: `getText` call is potentially expensive.
        adapter2.isTag(elem2) || adapter2.getText(elem2) !== ""
      ));
    },
    "first-child"(elem, { adapter: adapter2, equals }) {
      if (adapter2.prevElementSibling) {
        return adapter2.prevElementSibling(elem) == null;
      }
      const firstChild = adapter2.getSiblings(elem).find((elem2) => adapter2.isTag(elem2));
      return firstChild != null && equals(elem, firstChild);
    },
    "last-child"(elem, { adapter: adapter2, equals }) {
      const siblings = adapter2.getSiblings(elem);
      for (let i = siblings.length - 1; i >= 0; i--) {
        if (equals(elem, siblings[i]))
          return true;
        if (adapter2.isTag(siblings[i]))
          break;
      }
      return false;
    },
    "first-of-type"(elem, { adapter: adapter2, equals }) {
      const siblings = adapter2.getSiblings(elem);
      const elemName = adapter2.getName(elem);
      for (let i = 0; i < siblings.length; i++) {
        const currentSibling = siblings[i];
        if (equals(elem, currentSibling))
          return true;
        if (adapter2.isTag(currentSibling) && adapter2.getName(currentSibling) === elemName) {
          break;
        }
      }
      return false;
    },
    "last-of-type"(elem, { adapter: adapter2, equals }) {
      const siblings = adapter2.getSiblings(elem);
      const elemName = adapter2.getName(elem);
      for (let i = siblings.length - 1; i >= 0; i--) {
        const currentSibling = siblings[i];
        if (equals(elem, currentSibling))
          return true;
        if (adapter2.isTag(currentSibling) && adapter2.getName(currentSibling) === elemName) {
          break;
        }
      }
      return false;
    },
    "only-of-type"(elem, { adapter: adapter2, equals }) {
      const elemName = adapter2.getName(elem);
      return adapter2.getSiblings(elem).every((sibling) => equals(elem, sibling) || !adapter2.isTag(sibling) || adapter2.getName(sibling) !== elemName);
    },
    "only-child"(elem, { adapter: adapter2, equals }) {
      return adapter2.getSiblings(elem).every((sibling) => equals(elem, sibling) || !adapter2.isTag(sibling));
    }
  };
  function verifyPseudoArgs(func, name, subselect, argIndex) {
    if (subselect === null) {
      if (func.length > argIndex) {
        throw new Error(`Pseudo-class :${name} requires an argument`);
      }
    } else if (func.length === argIndex) {
      throw new Error(`Pseudo-class :${name} doesn't have any arguments`);
    }
  }
  var aliases = {
    // Links
    "any-link": ":is(a, area, link)[href]",
    link: ":any-link:not(:visited)",
    // Forms
    // https://html.spec.whatwg.org/multipage/scripting.html#disabled-elements
    disabled: `:is(
        :is(button, input, select, textarea, optgroup, option)[disabled],
        optgroup[disabled] > option,
        fieldset[disabled]:not(fieldset[disabled] legend:first-of-type *)
    )`,
    enabled: ":not(:disabled)",
    checked: ":is(:is(input[type=radio], input[type=checkbox])[checked], option:selected)",
    required: ":is(input, select, textarea)[required]",
    optional: ":is(input, select, textarea):not([required])",
    // JQuery extensions
    // https://html.spec.whatwg.org/multipage/form-elements.html#concept-option-selectedness
    selected: "option:is([selected], select:not([multiple]):not(:has(> option[selected])) > :first-of-type)",
    checkbox: "[type=checkbox]",
    file: "[type=file]",
    password: "[type=password]",
    radio: "[type=radio]",
    reset: "[type=reset]",
    image: "[type=image]",
    submit: "[type=submit]",
    parent: ":not(:empty)",
    header: ":is(h1, h2, h3, h4, h5, h6)",
    button: ":is(button, input[type=button])",
    input: ":is(input, textarea, select, button)",
    text: "input:is(:not([type!='']), [type=text])"
  };
  var PLACEHOLDER_ELEMENT = {};
  function ensureIsTag(next, adapter2) {
    if (next === boolbase.falseFunc)
      return boolbase.falseFunc;
    return (elem) => adapter2.isTag(elem) && next(elem);
  }
  function getNextSiblings(elem, adapter2) {
    const siblings = adapter2.getSiblings(elem);
    if (siblings.length <= 1)
      return [];
    const elemIndex = siblings.indexOf(elem);
    if (elemIndex < 0 || elemIndex === siblings.length - 1)
      return [];
    return siblings.slice(elemIndex + 1).filter(adapter2.isTag);
  }
  function copyOptions(options) {
    return {
      xmlMode: !!options.xmlMode,
      lowerCaseAttributeNames: !!options.lowerCaseAttributeNames,
      lowerCaseTags: !!options.lowerCaseTags,
      quirksMode: !!options.quirksMode,
      cacheResults: !!options.cacheResults,
      pseudos: options.pseudos,
      adapter: options.adapter,
      equals: options.equals
    };
  }
  var is$1 = (next, token, options, context, compileToken2) => {
    const func = compileToken2(token, copyOptions(options), context);
    return func === boolbase.trueFunc ? next : func === boolbase.falseFunc ? boolbase.falseFunc : (elem) => func(elem) && next(elem);
  };
  var subselects = {
    is: is$1,
    /**
     * `:matches` and `:where` are aliases for `:is`.
     */
    matches: is$1,
    where: is$1,
    not(next, token, options, context, compileToken2) {
      const func = compileToken2(token, copyOptions(options), context);
      return func === boolbase.falseFunc ? next : func === boolbase.trueFunc ? boolbase.falseFunc : (elem) => !func(elem) && next(elem);
    },
    has(next, subselect, options, _context, compileToken2) {
      const { adapter: adapter2 } = options;
      const opts = copyOptions(options);
      opts.relativeSelector = true;
      const context = subselect.some((s) => s.some(isTraversal)) ? (
        // Used as a placeholder. Will be replaced with the actual element.
        [PLACEHOLDER_ELEMENT]
      ) : void 0;
      const compiled = compileToken2(subselect, opts, context);
      if (compiled === boolbase.falseFunc)
        return boolbase.falseFunc;
      const hasElement = ensureIsTag(compiled, adapter2);
      if (context && compiled !== boolbase.trueFunc) {
        const { shouldTestNextSiblings = false } = compiled;
        return (elem) => {
          if (!next(elem))
            return false;
          context[0] = elem;
          const childs = adapter2.getChildren(elem);
          const nextElements = shouldTestNextSiblings ? [...childs, ...getNextSiblings(elem, adapter2)] : childs;
          return adapter2.existsOne(hasElement, nextElements);
        };
      }
      return (elem) => next(elem) && adapter2.existsOne(hasElement, adapter2.getChildren(elem));
    }
  };
  function compilePseudoSelector(next, selector, options, context, compileToken2) {
    var _a2;
    const { name, data } = selector;
    if (Array.isArray(data)) {
      if (!(name in subselects)) {
        throw new Error(`Unknown pseudo-class :${name}(${data})`);
      }
      return subselects[name](next, data, options, context, compileToken2);
    }
    const userPseudo = (_a2 = options.pseudos) === null || _a2 === void 0 ? void 0 : _a2[name];
    const stringPseudo = typeof userPseudo === "string" ? userPseudo : aliases[name];
    if (typeof stringPseudo === "string") {
      if (data != null) {
        throw new Error(`Pseudo ${name} doesn't have any arguments`);
      }
      const alias = parse$3(stringPseudo);
      return subselects["is"](next, alias, options, context, compileToken2);
    }
    if (typeof userPseudo === "function") {
      verifyPseudoArgs(userPseudo, name, data, 1);
      return (elem) => userPseudo(elem, data) && next(elem);
    }
    if (name in filters) {
      return filters[name](next, data, options, context);
    }
    if (name in pseudos) {
      const pseudo = pseudos[name];
      verifyPseudoArgs(pseudo, name, data, 2);
      return (elem) => pseudo(elem, options, data) && next(elem);
    }
    throw new Error(`Unknown pseudo-class :${name}`);
  }
  function getElementParent(node, adapter2) {
    const parent = adapter2.getParent(node);
    if (parent && adapter2.isTag(parent)) {
      return parent;
    }
    return null;
  }
  function compileGeneralSelector(next, selector, options, context, compileToken2) {
    const { adapter: adapter2, equals } = options;
    switch (selector.type) {
      case SelectorType.PseudoElement: {
        throw new Error("Pseudo-elements are not supported by css-select");
      }
      case SelectorType.ColumnCombinator: {
        throw new Error("Column combinators are not yet supported by css-select");
      }
      case SelectorType.Attribute: {
        if (selector.namespace != null) {
          throw new Error("Namespaced attributes are not yet supported by css-select");
        }
        if (!options.xmlMode || options.lowerCaseAttributeNames) {
          selector.name = selector.name.toLowerCase();
        }
        return attributeRules[selector.action](next, selector, options);
      }
      case SelectorType.Pseudo: {
        return compilePseudoSelector(next, selector, options, context, compileToken2);
      }
      // Tags
      case SelectorType.Tag: {
        if (selector.namespace != null) {
          throw new Error("Namespaced tag names are not yet supported by css-select");
        }
        let { name } = selector;
        if (!options.xmlMode || options.lowerCaseTags) {
          name = name.toLowerCase();
        }
        return function tag(elem) {
          return adapter2.getName(elem) === name && next(elem);
        };
      }
      // Traversal
      case SelectorType.Descendant: {
        if (options.cacheResults === false || typeof WeakSet === "undefined") {
          return function descendant(elem) {
            let current = elem;
            while (current = getElementParent(current, adapter2)) {
              if (next(current)) {
                return true;
              }
            }
            return false;
          };
        }
        const isFalseCache = /* @__PURE__ */ new WeakSet();
        return function cachedDescendant(elem) {
          let current = elem;
          while (current = getElementParent(current, adapter2)) {
            if (!isFalseCache.has(current)) {
              if (adapter2.isTag(current) && next(current)) {
                return true;
              }
              isFalseCache.add(current);
            }
          }
          return false;
        };
      }
      case "_flexibleDescendant": {
        return function flexibleDescendant(elem) {
          let current = elem;
          do {
            if (next(current))
              return true;
          } while (current = getElementParent(current, adapter2));
          return false;
        };
      }
      case SelectorType.Parent: {
        return function parent(elem) {
          return adapter2.getChildren(elem).some((elem2) => adapter2.isTag(elem2) && next(elem2));
        };
      }
      case SelectorType.Child: {
        return function child(elem) {
          const parent = adapter2.getParent(elem);
          return parent != null && adapter2.isTag(parent) && next(parent);
        };
      }
      case SelectorType.Sibling: {
        return function sibling(elem) {
          const siblings = adapter2.getSiblings(elem);
          for (let i = 0; i < siblings.length; i++) {
            const currentSibling = siblings[i];
            if (equals(elem, currentSibling))
              break;
            if (adapter2.isTag(currentSibling) && next(currentSibling)) {
              return true;
            }
          }
          return false;
        };
      }
      case SelectorType.Adjacent: {
        if (adapter2.prevElementSibling) {
          return function adjacent(elem) {
            const previous = adapter2.prevElementSibling(elem);
            return previous != null && next(previous);
          };
        }
        return function adjacent(elem) {
          const siblings = adapter2.getSiblings(elem);
          let lastElement;
          for (let i = 0; i < siblings.length; i++) {
            const currentSibling = siblings[i];
            if (equals(elem, currentSibling))
              break;
            if (adapter2.isTag(currentSibling)) {
              lastElement = currentSibling;
            }
          }
          return !!lastElement && next(lastElement);
        };
      }
      case SelectorType.Universal: {
        if (selector.namespace != null && selector.namespace !== "*") {
          throw new Error("Namespaced universal selectors are not yet supported by css-select");
        }
        return next;
      }
    }
  }
  function compile$1(selector, options, context) {
    const next = compileUnsafe(selector, options, context);
    return ensureIsTag(next, options.adapter);
  }
  function compileUnsafe(selector, options, context) {
    const token = typeof selector === "string" ? parse$3(selector) : selector;
    return compileToken(token, options, context);
  }
  function includesScopePseudo(t) {
    return t.type === SelectorType.Pseudo && (t.name === "scope" || Array.isArray(t.data) && t.data.some((data) => data.some(includesScopePseudo)));
  }
  var DESCENDANT_TOKEN = { type: SelectorType.Descendant };
  var FLEXIBLE_DESCENDANT_TOKEN = {
    type: "_flexibleDescendant"
  };
  var SCOPE_TOKEN = {
    type: SelectorType.Pseudo,
    name: "scope",
    data: null
  };
  function absolutize(token, { adapter: adapter2 }, context) {
    const hasContext = !!(context === null || context === void 0 ? void 0 : context.every((e) => {
      const parent = adapter2.isTag(e) && adapter2.getParent(e);
      return e === PLACEHOLDER_ELEMENT || parent && adapter2.isTag(parent);
    }));
    for (const t of token) {
      if (t.length > 0 && isTraversal(t[0]) && t[0].type !== SelectorType.Descendant) ;
      else if (hasContext && !t.some(includesScopePseudo)) {
        t.unshift(DESCENDANT_TOKEN);
      } else {
        continue;
      }
      t.unshift(SCOPE_TOKEN);
    }
  }
  function compileToken(token, options, context) {
    var _a2;
    token.forEach(sortByProcedure);
    context = (_a2 = options.context) !== null && _a2 !== void 0 ? _a2 : context;
    const isArrayContext = Array.isArray(context);
    const finalContext = context && (Array.isArray(context) ? context : [context]);
    if (options.relativeSelector !== false) {
      absolutize(token, options, finalContext);
    } else if (token.some((t) => t.length > 0 && isTraversal(t[0]))) {
      throw new Error("Relative selectors are not allowed when the `relativeSelector` option is disabled");
    }
    let shouldTestNextSiblings = false;
    const query2 = token.map((rules) => {
      if (rules.length >= 2) {
        const [first, second] = rules;
        if (first.type !== SelectorType.Pseudo || first.name !== "scope") ;
        else if (isArrayContext && second.type === SelectorType.Descendant) {
          rules[1] = FLEXIBLE_DESCENDANT_TOKEN;
        } else if (second.type === SelectorType.Adjacent || second.type === SelectorType.Sibling) {
          shouldTestNextSiblings = true;
        }
      }
      return compileRules(rules, options, finalContext);
    }).reduce(reduceRules, boolbase.falseFunc);
    query2.shouldTestNextSiblings = shouldTestNextSiblings;
    return query2;
  }
  function compileRules(rules, options, context) {
    var _a2;
    return rules.reduce((previous, rule) => previous === boolbase.falseFunc ? boolbase.falseFunc : compileGeneralSelector(previous, rule, options, context, compileToken), (_a2 = options.rootFunc) !== null && _a2 !== void 0 ? _a2 : boolbase.trueFunc);
  }
  function reduceRules(a, b) {
    if (b === boolbase.falseFunc || a === boolbase.trueFunc) {
      return a;
    }
    if (a === boolbase.falseFunc || b === boolbase.trueFunc) {
      return b;
    }
    return function combine(elem) {
      return a(elem) || b(elem);
    };
  }
  var defaultEquals = (a, b) => a === b;
  var defaultOptions = {
    adapter: DomUtils,
    equals: defaultEquals
  };
  function convertOptionFormats(options) {
    var _a2, _b, _c, _d;
    const opts = options !== null && options !== void 0 ? options : defaultOptions;
    (_a2 = opts.adapter) !== null && _a2 !== void 0 ? _a2 : opts.adapter = DomUtils;
    (_b = opts.equals) !== null && _b !== void 0 ? _b : opts.equals = (_d = (_c = opts.adapter) === null || _c === void 0 ? void 0 : _c.equals) !== null && _d !== void 0 ? _d : defaultEquals;
    return opts;
  }
  function wrapCompile(func) {
    return function addAdapter(selector, options, context) {
      const opts = convertOptionFormats(options);
      return func(selector, opts, context);
    };
  }
  var compile = wrapCompile(compile$1);
  function is(elem, query2, options) {
    const opts = convertOptionFormats(options);
    return (typeof query2 === "function" ? query2 : compile$1(query2, opts))(elem);
  }
  var { isArray } = Array;
  var isTag = ({ nodeType }) => nodeType === ELEMENT_NODE;
  var existsOne = (test, elements) => elements.some(
    (element) => isTag(element) && (test(element) || existsOne(test, getChildren(element)))
  );
  var getAttributeValue = (element, name) => name === "class" ? element.classList.value : element.getAttribute(name);
  var getChildren = ({ childNodes }) => childNodes;
  var getName = (element) => {
    const { localName } = element;
    return ignoreCase(element) ? localName.toLowerCase() : localName;
  };
  var getParent = ({ parentNode }) => parentNode;
  var getSiblings = (element) => {
    const { parentNode } = element;
    return parentNode ? getChildren(parentNode) : element;
  };
  var getText = (node) => {
    if (isArray(node))
      return node.map(getText).join("");
    if (isTag(node))
      return getText(getChildren(node));
    if (node.nodeType === TEXT_NODE)
      return node.data;
    return "";
  };
  var hasAttrib = (element, name) => element.hasAttribute(name);
  var removeSubsets = (nodes) => {
    let { length } = nodes;
    while (length--) {
      const node = nodes[length];
      if (length && -1 < nodes.lastIndexOf(node, length - 1)) {
        nodes.splice(length, 1);
        continue;
      }
      for (let { parentNode } = node; parentNode; parentNode = parentNode.parentNode) {
        if (nodes.includes(parentNode)) {
          nodes.splice(length, 1);
          break;
        }
      }
    }
    return nodes;
  };
  var findAll = (test, nodes) => {
    const matches2 = [];
    for (const node of nodes) {
      if (isTag(node)) {
        if (test(node))
          matches2.push(node);
        matches2.push(...findAll(test, getChildren(node)));
      }
    }
    return matches2;
  };
  var findOne = (test, nodes) => {
    for (let node of nodes)
      if (test(node) || (node = findOne(test, getChildren(node))))
        return node;
    return null;
  };
  var adapter = {
    isTag,
    existsOne,
    getAttributeValue,
    getChildren,
    getName,
    getParent,
    getSiblings,
    getText,
    hasAttrib,
    removeSubsets,
    findAll,
    findOne
  };
  var prepareMatch = (element, selectors) => compile(
    selectors,
    {
      context: selectors.includes(":scope") ? element : void 0,
      xmlMode: !ignoreCase(element),
      adapter
    }
  );
  var matches = (element, selectors) => is(
    element,
    selectors,
    {
      strict: true,
      context: selectors.includes(":scope") ? element : void 0,
      xmlMode: !ignoreCase(element),
      adapter
    }
  );
  var Text$1 = class Text2 extends CharacterData$1 {
    constructor(ownerDocument, data = "") {
      super(ownerDocument, "#text", TEXT_NODE, data);
    }
    get wholeText() {
      const text3 = [];
      let { previousSibling: previousSibling2, nextSibling: nextSibling2 } = this;
      while (previousSibling2) {
        if (previousSibling2.nodeType === TEXT_NODE)
          text3.unshift(previousSibling2[VALUE]);
        else
          break;
        previousSibling2 = previousSibling2.previousSibling;
      }
      text3.push(this[VALUE]);
      while (nextSibling2) {
        if (nextSibling2.nodeType === TEXT_NODE)
          text3.push(nextSibling2[VALUE]);
        else
          break;
        nextSibling2 = nextSibling2.nextSibling;
      }
      return text3.join("");
    }
    cloneNode() {
      const { ownerDocument, [VALUE]: data } = this;
      return new Text2(ownerDocument, data);
    }
    toString() {
      return escape(this[VALUE]);
    }
  };
  var isNode = (node) => node instanceof Node$1;
  var insert = (parentNode, child, nodes) => {
    const { ownerDocument } = parentNode;
    for (const node of nodes)
      parentNode.insertBefore(
        isNode(node) ? node : new Text$1(ownerDocument, node),
        child
      );
  };
  var ParentNode = class extends Node$1 {
    constructor(ownerDocument, localName, nodeType) {
      super(ownerDocument, localName, nodeType);
      this[PRIVATE] = null;
      this[NEXT] = this[END] = {
        [NEXT]: null,
        [PREV]: this,
        [START]: this,
        nodeType: NODE_END,
        ownerDocument: this.ownerDocument,
        parentNode: null
      };
    }
    get childNodes() {
      const childNodes = new NodeList();
      let { firstChild } = this;
      while (firstChild) {
        childNodes.push(firstChild);
        firstChild = nextSibling(firstChild);
      }
      return childNodes;
    }
    get children() {
      const children = new NodeList();
      let { firstElementChild } = this;
      while (firstElementChild) {
        children.push(firstElementChild);
        firstElementChild = nextElementSibling(firstElementChild);
      }
      return children;
    }
    /**
     * @returns {NodeStruct | null}
     */
    get firstChild() {
      let { [NEXT]: next, [END]: end2 } = this;
      while (next.nodeType === ATTRIBUTE_NODE)
        next = next[NEXT];
      return next === end2 ? null : next;
    }
    /**
     * @returns {NodeStruct | null}
     */
    get firstElementChild() {
      let { firstChild } = this;
      while (firstChild) {
        if (firstChild.nodeType === ELEMENT_NODE)
          return firstChild;
        firstChild = nextSibling(firstChild);
      }
      return null;
    }
    get lastChild() {
      const prev = this[END][PREV];
      switch (prev.nodeType) {
        case NODE_END:
          return prev[START];
        case ATTRIBUTE_NODE:
          return null;
      }
      return prev === this ? null : prev;
    }
    get lastElementChild() {
      let { lastChild } = this;
      while (lastChild) {
        if (lastChild.nodeType === ELEMENT_NODE)
          return lastChild;
        lastChild = previousSibling(lastChild);
      }
      return null;
    }
    get childElementCount() {
      return this.children.length;
    }
    prepend(...nodes) {
      insert(this, this.firstChild, nodes);
    }
    append(...nodes) {
      insert(this, this[END], nodes);
    }
    replaceChildren(...nodes) {
      let { [NEXT]: next, [END]: end2 } = this;
      while (next !== end2 && next.nodeType === ATTRIBUTE_NODE)
        next = next[NEXT];
      while (next !== end2) {
        const after2 = getEnd(next)[NEXT];
        next.remove();
        next = after2;
      }
      if (nodes.length)
        insert(this, end2, nodes);
    }
    getElementsByClassName(className) {
      const elements = new NodeList();
      let { [NEXT]: next, [END]: end2 } = this;
      while (next !== end2) {
        if (next.nodeType === ELEMENT_NODE && next.hasAttribute("class") && next.classList.has(className))
          elements.push(next);
        next = next[NEXT];
      }
      return elements;
    }
    getElementsByTagName(tagName2) {
      const elements = new NodeList();
      let { [NEXT]: next, [END]: end2 } = this;
      while (next !== end2) {
        if (next.nodeType === ELEMENT_NODE && (next.localName === tagName2 || localCase(next) === tagName2))
          elements.push(next);
        next = next[NEXT];
      }
      return elements;
    }
    querySelector(selectors) {
      const matches2 = prepareMatch(this, selectors);
      let { [NEXT]: next, [END]: end2 } = this;
      while (next !== end2) {
        if (next.nodeType === ELEMENT_NODE && matches2(next))
          return next;
        next = next.nodeType === ELEMENT_NODE && next.localName === "template" ? next[END] : next[NEXT];
      }
      return null;
    }
    querySelectorAll(selectors) {
      const matches2 = prepareMatch(this, selectors);
      const elements = new NodeList();
      let { [NEXT]: next, [END]: end2 } = this;
      while (next !== end2) {
        if (next.nodeType === ELEMENT_NODE && matches2(next))
          elements.push(next);
        next = next.nodeType === ELEMENT_NODE && next.localName === "template" ? next[END] : next[NEXT];
      }
      return elements;
    }
    appendChild(node) {
      return this.insertBefore(node, this[END]);
    }
    contains(node) {
      let parentNode = node;
      while (parentNode && parentNode !== this)
        parentNode = parentNode.parentNode;
      return parentNode === this;
    }
    insertBefore(node, before2 = null) {
      if (node === before2)
        return node;
      if (node === this)
        throw new Error("unable to append a node to itself");
      const next = before2 || this[END];
      switch (node.nodeType) {
        case ELEMENT_NODE:
          node.remove();
          node.parentNode = this;
          knownBoundaries(next[PREV], node, next);
          moCallback(node, null);
          connectedCallback(node);
          break;
        case DOCUMENT_FRAGMENT_NODE: {
          let { [PRIVATE]: parentNode, firstChild, lastChild } = node;
          if (firstChild) {
            knownSegment(next[PREV], firstChild, lastChild, next);
            knownAdjacent(node, node[END]);
            if (parentNode)
              parentNode.replaceChildren();
            do {
              firstChild.parentNode = this;
              moCallback(firstChild, null);
              if (firstChild.nodeType === ELEMENT_NODE)
                connectedCallback(firstChild);
            } while (firstChild !== lastChild && (firstChild = nextSibling(firstChild)));
          }
          break;
        }
        case TEXT_NODE:
        case COMMENT_NODE:
        case CDATA_SECTION_NODE:
          node.remove();
        /* eslint no-fallthrough:0 */
        // this covers DOCUMENT_TYPE_NODE too
        default:
          node.parentNode = this;
          knownSiblings(next[PREV], node, next);
          moCallback(node, null);
          break;
      }
      return node;
    }
    normalize() {
      let { [NEXT]: next, [END]: end2 } = this;
      while (next !== end2) {
        const { [NEXT]: $next, [PREV]: $prev, nodeType } = next;
        if (nodeType === TEXT_NODE) {
          if (!next[VALUE])
            next.remove();
          else if ($prev && $prev.nodeType === TEXT_NODE) {
            $prev.textContent += next.textContent;
            next.remove();
          }
        }
        next = $next;
      }
    }
    removeChild(node) {
      if (node.parentNode !== this)
        throw new Error("node is not a child");
      node.remove();
      return node;
    }
    replaceChild(node, replaced) {
      const next = getEnd(replaced)[NEXT];
      replaced.remove();
      this.insertBefore(node, next);
      return replaced;
    }
  };
  var NonElementParentNode = class extends ParentNode {
    getElementById(id) {
      let { [NEXT]: next, [END]: end2 } = this;
      while (next !== end2) {
        if (next.nodeType === ELEMENT_NODE && next.id === id)
          return next;
        next = next[NEXT];
      }
      return null;
    }
    cloneNode(deep) {
      const { ownerDocument, constructor } = this;
      const nonEPN = new constructor(ownerDocument);
      if (deep) {
        const { [END]: end2 } = nonEPN;
        for (const node of this.childNodes)
          nonEPN.insertBefore(node.cloneNode(deep), end2);
      }
      return nonEPN;
    }
    toString() {
      const { childNodes, localName } = this;
      return `<${localName}>${childNodes.join("")}</${localName}>`;
    }
    toJSON() {
      const json = [];
      nonElementAsJSON(this, json);
      return json;
    }
  };
  var DocumentFragment$1 = class DocumentFragment extends NonElementParentNode {
    constructor(ownerDocument) {
      super(ownerDocument, "#document-fragment", DOCUMENT_FRAGMENT_NODE);
    }
  };
  var DocumentType$1 = class DocumentType extends Node$1 {
    constructor(ownerDocument, name, publicId = "", systemId = "") {
      super(ownerDocument, "#document-type", DOCUMENT_TYPE_NODE);
      this.name = name;
      this.publicId = publicId;
      this.systemId = systemId;
    }
    cloneNode() {
      const { ownerDocument, name, publicId, systemId } = this;
      return new DocumentType(ownerDocument, name, publicId, systemId);
    }
    toString() {
      const { name, publicId, systemId } = this;
      const hasPublic = 0 < publicId.length;
      const str = [name];
      if (hasPublic)
        str.push("PUBLIC", `"${publicId}"`);
      if (systemId.length) {
        if (!hasPublic)
          str.push("SYSTEM");
        str.push(`"${systemId}"`);
      }
      return `<!DOCTYPE ${str.join(" ")}>`;
    }
    toJSON() {
      const json = [];
      documentTypeAsJSON(this, json);
      return json;
    }
  };
  var getInnerHtml = (node) => node.childNodes.join("");
  var setInnerHtml = (node, html3) => {
    const { ownerDocument } = node;
    const { constructor } = ownerDocument;
    const document3 = new constructor();
    document3[CUSTOM_ELEMENTS] = ownerDocument[CUSTOM_ELEMENTS];
    const { childNodes } = parseFromString(document3, ignoreCase(node), html3);
    node.replaceChildren(...childNodes.map(setOwnerDocument, ownerDocument));
  };
  function setOwnerDocument(node) {
    node.ownerDocument = this;
    switch (node.nodeType) {
      case ELEMENT_NODE:
      case DOCUMENT_FRAGMENT_NODE:
        node.childNodes.forEach(setOwnerDocument, this);
        break;
    }
    return node;
  }
  var uhyphen = (camel) => camel.replace(/(([A-Z0-9])([A-Z0-9][a-z]))|(([a-z0-9]+)([A-Z]))/g, "$2$5-$3$6").toLowerCase();
  var refs$1 = /* @__PURE__ */ new WeakMap();
  var key = (name) => `data-${uhyphen(name)}`;
  var prop = (name) => name.slice(5).replace(/-([a-z])/g, (_, $1) => $1.toUpperCase());
  var handler$2 = {
    get(dataset, name) {
      if (name in dataset)
        return refs$1.get(dataset).getAttribute(key(name));
    },
    set(dataset, name, value) {
      dataset[name] = value;
      refs$1.get(dataset).setAttribute(key(name), value);
      return true;
    },
    deleteProperty(dataset, name) {
      if (name in dataset)
        refs$1.get(dataset).removeAttribute(key(name));
      return delete dataset[name];
    }
  };
  var DOMStringMap = class {
    /**
     * @param {Element} ref
     */
    constructor(ref) {
      for (const { name, value } of ref.attributes) {
        if (/^data-/.test(name))
          this[prop(name)] = value;
      }
      refs$1.set(this, ref);
      return new Proxy(this, handler$2);
    }
  };
  setPrototypeOf(DOMStringMap.prototype, null);
  var { add } = Set.prototype;
  var addTokens = (self, tokens) => {
    for (const token of tokens) {
      if (token)
        add.call(self, token);
    }
  };
  var update = ({ [OWNER_ELEMENT]: ownerElement, value }) => {
    const attribute2 = ownerElement.getAttributeNode("class");
    if (attribute2)
      attribute2.value = value;
    else
      setAttribute(
        ownerElement,
        new Attr$1(ownerElement.ownerDocument, "class", value)
      );
  };
  var DOMTokenList = class extends Set {
    constructor(ownerElement) {
      super();
      this[OWNER_ELEMENT] = ownerElement;
      const attribute2 = ownerElement.getAttributeNode("class");
      if (attribute2)
        addTokens(this, attribute2.value.split(/\s+/));
    }
    get length() {
      return this.size;
    }
    get value() {
      return [...this].join(" ");
    }
    /**
     * @param  {...string} tokens
     */
    add(...tokens) {
      addTokens(this, tokens);
      update(this);
    }
    /**
     * @param {string} token
     */
    contains(token) {
      return this.has(token);
    }
    /**
     * @param  {...string} tokens
     */
    remove(...tokens) {
      for (const token of tokens)
        this.delete(token);
      update(this);
    }
    /**
     * @param {string} token
     * @param {boolean?} force
     */
    toggle(token, force) {
      if (this.has(token)) {
        if (force)
          return true;
        this.delete(token);
        update(this);
      } else if (force || arguments.length === 1) {
        super.add(token);
        update(this);
        return true;
      }
      return false;
    }
    /**
     * @param {string} token
     * @param {string} newToken
     */
    replace(token, newToken) {
      if (this.has(token)) {
        this.delete(token);
        super.add(newToken);
        update(this);
        return true;
      }
      return false;
    }
    /**
     * @param {string} token
     */
    supports() {
      return true;
    }
  };
  var refs = /* @__PURE__ */ new WeakMap();
  var getKeys = (style) => [...style.keys()].filter((key2) => key2 !== PRIVATE);
  var updateKeys = (style) => {
    const attr = refs.get(style).getAttributeNode("style");
    if (!attr || attr[CHANGED] || style.get(PRIVATE) !== attr) {
      style.clear();
      if (attr) {
        style.set(PRIVATE, attr);
        for (const rule of attr[VALUE].split(/\s*;\s*/)) {
          let [key2, ...rest] = rule.split(":");
          if (rest.length > 0) {
            key2 = key2.trim();
            const value = rest.join(":").trim();
            if (key2 && value)
              style.set(key2, value);
          }
        }
      }
    }
    return attr;
  };
  var handler$1 = {
    get(style, name) {
      if (name in prototype)
        return style[name];
      updateKeys(style);
      if (name === "length")
        return getKeys(style).length;
      if (/^\d+$/.test(name))
        return getKeys(style)[name];
      return style.get(uhyphen(name));
    },
    set(style, name, value) {
      if (name === "cssText")
        style[name] = value;
      else {
        let attr = updateKeys(style);
        if (value == null)
          style.delete(uhyphen(name));
        else
          style.set(uhyphen(name), value);
        if (!attr) {
          const element = refs.get(style);
          attr = element.ownerDocument.createAttribute("style");
          element.setAttributeNode(attr);
          style.set(PRIVATE, attr);
        }
        attr[CHANGED] = false;
        attr[VALUE] = style.toString();
      }
      return true;
    }
  };
  var CSSStyleDeclaration$1 = class CSSStyleDeclaration extends Map {
    constructor(element) {
      super();
      refs.set(this, element);
      return new Proxy(this, handler$1);
    }
    get cssText() {
      return this.toString();
    }
    set cssText(value) {
      refs.get(this).setAttribute("style", value);
    }
    getPropertyValue(name) {
      const self = this[PRIVATE];
      return handler$1.get(self, name);
    }
    setProperty(name, value) {
      const self = this[PRIVATE];
      handler$1.set(self, name, value);
    }
    removeProperty(name) {
      const self = this[PRIVATE];
      handler$1.set(self, name, null);
    }
    [Symbol.iterator]() {
      const self = this[PRIVATE];
      updateKeys(self);
      const keys2 = getKeys(self);
      const { length } = keys2;
      let i = 0;
      return {
        next() {
          const done = i === length;
          return { done, value: done ? null : keys2[i++] };
        }
      };
    }
    get [PRIVATE]() {
      return this;
    }
    toString() {
      const self = this[PRIVATE];
      updateKeys(self);
      const cssText = [];
      self.forEach(push, cssText);
      return cssText.join(";");
    }
  };
  var { prototype } = CSSStyleDeclaration$1;
  function push(value, key2) {
    if (key2 !== PRIVATE)
      this.push(`${key2}:${value}`);
  }
  var BUBBLING_PHASE = 3;
  var AT_TARGET = 2;
  var CAPTURING_PHASE = 1;
  var NONE = 0;
  function getCurrentTarget(ev) {
    return ev.currentTarget;
  }
  var GlobalEvent = class {
    static get BUBBLING_PHASE() {
      return BUBBLING_PHASE;
    }
    static get AT_TARGET() {
      return AT_TARGET;
    }
    static get CAPTURING_PHASE() {
      return CAPTURING_PHASE;
    }
    static get NONE() {
      return NONE;
    }
    constructor(type, eventInitDict = {}) {
      this.type = type;
      this.bubbles = !!eventInitDict.bubbles;
      this.cancelBubble = false;
      this._stopImmediatePropagationFlag = false;
      this.cancelable = !!eventInitDict.cancelable;
      this.eventPhase = this.NONE;
      this.timeStamp = Date.now();
      this.defaultPrevented = false;
      this.originalTarget = null;
      this.returnValue = null;
      this.srcElement = null;
      this.target = null;
      this._path = [];
    }
    get BUBBLING_PHASE() {
      return BUBBLING_PHASE;
    }
    get AT_TARGET() {
      return AT_TARGET;
    }
    get CAPTURING_PHASE() {
      return CAPTURING_PHASE;
    }
    get NONE() {
      return NONE;
    }
    preventDefault() {
      this.defaultPrevented = true;
    }
    // simplified implementation, should be https://dom.spec.whatwg.org/#dom-event-composedpath
    composedPath() {
      return this._path.map(getCurrentTarget);
    }
    stopPropagation() {
      this.cancelBubble = true;
    }
    stopImmediatePropagation() {
      this.stopPropagation();
      this._stopImmediatePropagationFlag = true;
    }
  };
  var NamedNodeMap = class extends Array {
    constructor(ownerElement) {
      super();
      this.ownerElement = ownerElement;
    }
    getNamedItem(name) {
      return this.ownerElement.getAttributeNode(name);
    }
    setNamedItem(attr) {
      this.ownerElement.setAttributeNode(attr);
      this.unshift(attr);
    }
    removeNamedItem(name) {
      const item = this.getNamedItem(name);
      this.ownerElement.removeAttribute(name);
      this.splice(this.indexOf(item), 1);
    }
    item(index2) {
      return index2 < this.length ? this[index2] : null;
    }
    /* c8 ignore start */
    getNamedItemNS(_, name) {
      return this.getNamedItem(name);
    }
    setNamedItemNS(_, attr) {
      return this.setNamedItem(attr);
    }
    removeNamedItemNS(_, name) {
      return this.removeNamedItem(name);
    }
    /* c8 ignore stop */
  };
  var ShadowRoot$1 = class ShadowRoot extends NonElementParentNode {
    constructor(host) {
      super(host.ownerDocument, "#shadow-root", DOCUMENT_FRAGMENT_NODE);
      this.host = host;
    }
    get innerHTML() {
      return getInnerHtml(this);
    }
    set innerHTML(html3) {
      setInnerHtml(this, html3);
    }
  };
  var attributesHandler = {
    get(target, key2) {
      return key2 in target ? target[key2] : target.find(({ name }) => name === key2);
    }
  };
  var create = (ownerDocument, element, localName) => {
    if ("ownerSVGElement" in element) {
      const svg2 = ownerDocument.createElementNS(SVG_NAMESPACE, localName);
      svg2.ownerSVGElement = element.ownerSVGElement;
      return svg2;
    }
    return ownerDocument.createElement(localName);
  };
  var isVoid = ({ localName, ownerDocument }) => {
    return ownerDocument[MIME].voidElements.test(localName);
  };
  var Element$1 = class Element2 extends ParentNode {
    constructor(ownerDocument, localName) {
      super(ownerDocument, localName, ELEMENT_NODE);
      this[CLASS_LIST] = null;
      this[DATASET] = null;
      this[STYLE] = null;
    }
    // <Mixins>
    get isConnected() {
      return isConnected(this);
    }
    get parentElement() {
      return parentElement(this);
    }
    get previousSibling() {
      return previousSibling(this);
    }
    get nextSibling() {
      return nextSibling(this);
    }
    get namespaceURI() {
      return "http://www.w3.org/1999/xhtml";
    }
    get previousElementSibling() {
      return previousElementSibling(this);
    }
    get nextElementSibling() {
      return nextElementSibling(this);
    }
    before(...nodes) {
      before(this, nodes);
    }
    after(...nodes) {
      after(this, nodes);
    }
    replaceWith(...nodes) {
      replaceWith(this, nodes);
    }
    remove() {
      remove(this[PREV], this, this[END][NEXT]);
    }
    // </Mixins>
    // <specialGetters>
    get id() {
      return stringAttribute.get(this, "id");
    }
    set id(value) {
      stringAttribute.set(this, "id", value);
    }
    get className() {
      return this.classList.value;
    }
    set className(value) {
      const { classList } = this;
      classList.clear();
      classList.add(...$String(value).split(/\s+/));
    }
    get nodeName() {
      return localCase(this);
    }
    get tagName() {
      return localCase(this);
    }
    get classList() {
      return this[CLASS_LIST] || (this[CLASS_LIST] = new DOMTokenList(this));
    }
    get dataset() {
      return this[DATASET] || (this[DATASET] = new DOMStringMap(this));
    }
    getBoundingClientRect() {
      return {
        x: 0,
        y: 0,
        bottom: 0,
        height: 0,
        left: 0,
        right: 0,
        top: 0,
        width: 0
      };
    }
    get nonce() {
      return stringAttribute.get(this, "nonce");
    }
    set nonce(value) {
      stringAttribute.set(this, "nonce", value);
    }
    get style() {
      return this[STYLE] || (this[STYLE] = new CSSStyleDeclaration$1(this));
    }
    get tabIndex() {
      return numericAttribute.get(this, "tabindex") || -1;
    }
    set tabIndex(value) {
      numericAttribute.set(this, "tabindex", value);
    }
    get slot() {
      return stringAttribute.get(this, "slot");
    }
    set slot(value) {
      stringAttribute.set(this, "slot", value);
    }
    // </specialGetters>
    // <contentRelated>
    get innerText() {
      const text3 = [];
      let { [NEXT]: next, [END]: end2 } = this;
      while (next !== end2) {
        if (next.nodeType === TEXT_NODE) {
          text3.push(next.textContent.replace(/\s+/g, " "));
        } else if (text3.length && next[NEXT] != end2 && BLOCK_ELEMENTS.has(next.tagName)) {
          text3.push("\n");
        }
        next = next[NEXT];
      }
      return text3.join("");
    }
    /**
     * @returns {String}
     */
    get textContent() {
      const text3 = [];
      let { [NEXT]: next, [END]: end2 } = this;
      while (next !== end2) {
        const nodeType = next.nodeType;
        if (nodeType === TEXT_NODE || nodeType === CDATA_SECTION_NODE)
          text3.push(next.textContent);
        next = next[NEXT];
      }
      return text3.join("");
    }
    set textContent(text3) {
      this.replaceChildren();
      if (text3 != null && text3 !== "")
        this.appendChild(new Text$1(this.ownerDocument, text3));
    }
    get innerHTML() {
      return getInnerHtml(this);
    }
    set innerHTML(html3) {
      setInnerHtml(this, html3);
    }
    get outerHTML() {
      return this.toString();
    }
    set outerHTML(html3) {
      const template = this.ownerDocument.createElement("");
      template.innerHTML = html3;
      this.replaceWith(...template.childNodes);
    }
    // </contentRelated>
    // <attributes>
    get attributes() {
      const attributes2 = new NamedNodeMap(this);
      let next = this[NEXT];
      while (next.nodeType === ATTRIBUTE_NODE) {
        attributes2.push(next);
        next = next[NEXT];
      }
      return new Proxy(attributes2, attributesHandler);
    }
    focus() {
      this.dispatchEvent(new GlobalEvent("focus"));
    }
    getAttribute(name) {
      if (name === "class")
        return this.className;
      const attribute2 = this.getAttributeNode(name);
      return attribute2 && (ignoreCase(this) ? attribute2.value : escape(attribute2.value));
    }
    getAttributeNode(name) {
      let next = this[NEXT];
      while (next.nodeType === ATTRIBUTE_NODE) {
        if (next.name === name)
          return next;
        next = next[NEXT];
      }
      return null;
    }
    getAttributeNames() {
      const attributes2 = new NodeList();
      let next = this[NEXT];
      while (next.nodeType === ATTRIBUTE_NODE) {
        attributes2.push(next.name);
        next = next[NEXT];
      }
      return attributes2;
    }
    hasAttribute(name) {
      return !!this.getAttributeNode(name);
    }
    hasAttributes() {
      return this[NEXT].nodeType === ATTRIBUTE_NODE;
    }
    removeAttribute(name) {
      if (name === "class" && this[CLASS_LIST])
        this[CLASS_LIST].clear();
      let next = this[NEXT];
      while (next.nodeType === ATTRIBUTE_NODE) {
        if (next.name === name) {
          removeAttribute(this, next);
          return;
        }
        next = next[NEXT];
      }
    }
    removeAttributeNode(attribute2) {
      let next = this[NEXT];
      while (next.nodeType === ATTRIBUTE_NODE) {
        if (next === attribute2) {
          removeAttribute(this, next);
          return;
        }
        next = next[NEXT];
      }
    }
    setAttribute(name, value) {
      if (name === "class")
        this.className = value;
      else {
        const attribute2 = this.getAttributeNode(name);
        if (attribute2)
          attribute2.value = value;
        else
          setAttribute(this, new Attr$1(this.ownerDocument, name, value));
      }
    }
    setAttributeNode(attribute2) {
      const { name } = attribute2;
      const previously = this.getAttributeNode(name);
      if (previously !== attribute2) {
        if (previously)
          this.removeAttributeNode(previously);
        const { ownerElement } = attribute2;
        if (ownerElement)
          ownerElement.removeAttributeNode(attribute2);
        setAttribute(this, attribute2);
      }
      return previously;
    }
    toggleAttribute(name, force) {
      if (this.hasAttribute(name)) {
        if (!force) {
          this.removeAttribute(name);
          return false;
        }
        return true;
      } else if (force || arguments.length === 1) {
        this.setAttribute(name, "");
        return true;
      }
      return false;
    }
    // </attributes>
    // <ShadowDOM>
    get shadowRoot() {
      if (shadowRoots.has(this)) {
        const { mode, shadowRoot } = shadowRoots.get(this);
        if (mode === "open")
          return shadowRoot;
      }
      return null;
    }
    attachShadow(init) {
      if (shadowRoots.has(this))
        throw new Error("operation not supported");
      const shadowRoot = new ShadowRoot$1(this);
      shadowRoots.set(this, {
        mode: init.mode,
        shadowRoot
      });
      return shadowRoot;
    }
    // </ShadowDOM>
    // <selectors>
    matches(selectors) {
      return matches(this, selectors);
    }
    closest(selectors) {
      let parentElement2 = this;
      const matches2 = prepareMatch(parentElement2, selectors);
      while (parentElement2 && !matches2(parentElement2))
        parentElement2 = parentElement2.parentElement;
      return parentElement2;
    }
    // </selectors>
    // <insertAdjacent>
    insertAdjacentElement(position, element) {
      const { parentElement: parentElement2 } = this;
      switch (position) {
        case "beforebegin":
          if (parentElement2) {
            parentElement2.insertBefore(element, this);
            break;
          }
          return null;
        case "afterbegin":
          this.insertBefore(element, this.firstChild);
          break;
        case "beforeend":
          this.insertBefore(element, null);
          break;
        case "afterend":
          if (parentElement2) {
            parentElement2.insertBefore(element, this.nextSibling);
            break;
          }
          return null;
      }
      return element;
    }
    insertAdjacentHTML(position, html3) {
      this.insertAdjacentElement(position, htmlToFragment(this.ownerDocument, html3));
    }
    insertAdjacentText(position, text3) {
      const node = this.ownerDocument.createTextNode(text3);
      this.insertAdjacentElement(position, node);
    }
    // </insertAdjacent>
    cloneNode(deep = false) {
      const { ownerDocument, localName } = this;
      const addNext = (next2) => {
        next2.parentNode = parentNode;
        knownAdjacent($next, next2);
        $next = next2;
      };
      const clone2 = create(ownerDocument, this, localName);
      let parentNode = clone2, $next = clone2;
      let { [NEXT]: next, [END]: prev } = this;
      while (next !== prev && (deep || next.nodeType === ATTRIBUTE_NODE)) {
        switch (next.nodeType) {
          case NODE_END:
            knownAdjacent($next, parentNode[END]);
            $next = parentNode[END];
            parentNode = parentNode.parentNode;
            break;
          case ELEMENT_NODE: {
            const node = create(ownerDocument, next, next.localName);
            addNext(node);
            parentNode = node;
            break;
          }
          case ATTRIBUTE_NODE: {
            const attr = next.cloneNode(deep);
            attr.ownerElement = parentNode;
            addNext(attr);
            break;
          }
          case TEXT_NODE:
          case COMMENT_NODE:
          case CDATA_SECTION_NODE:
            addNext(next.cloneNode(deep));
            break;
        }
        next = next[NEXT];
      }
      knownAdjacent($next, clone2[END]);
      return clone2;
    }
    // <custom>
    toString() {
      const out = [];
      const { [END]: end2 } = this;
      let next = { [NEXT]: this };
      let isOpened = false;
      do {
        next = next[NEXT];
        switch (next.nodeType) {
          case ATTRIBUTE_NODE: {
            const attr = " " + next;
            switch (attr) {
              case " id":
              case " class":
              case " style":
                break;
              default:
                out.push(attr);
            }
            break;
          }
          case NODE_END: {
            const start = next[START];
            if (isOpened) {
              if ("ownerSVGElement" in start)
                out.push(" />");
              else if (isVoid(start))
                out.push(ignoreCase(start) ? ">" : " />");
              else
                out.push(`></${start.localName}>`);
              isOpened = false;
            } else
              out.push(`</${start.localName}>`);
            break;
          }
          case ELEMENT_NODE:
            if (isOpened)
              out.push(">");
            if (next.toString !== this.toString) {
              out.push(next.toString());
              next = next[END];
              isOpened = false;
            } else {
              out.push(`<${next.localName}`);
              isOpened = true;
            }
            break;
          case TEXT_NODE:
          case COMMENT_NODE:
          case CDATA_SECTION_NODE:
            out.push((isOpened ? ">" : "") + next);
            isOpened = false;
            break;
        }
      } while (next !== end2);
      return out.join("");
    }
    toJSON() {
      const json = [];
      elementAsJSON(this, json);
      return json;
    }
    // </custom>
    /* c8 ignore start */
    getAttributeNS(_, name) {
      return this.getAttribute(name);
    }
    getElementsByTagNameNS(_, name) {
      return this.getElementsByTagName(name);
    }
    hasAttributeNS(_, name) {
      return this.hasAttribute(name);
    }
    removeAttributeNS(_, name) {
      this.removeAttribute(name);
    }
    setAttributeNS(_, name, value) {
      this.setAttribute(name, value);
    }
    setAttributeNodeNS(attr) {
      return this.setAttributeNode(attr);
    }
    /* c8 ignore stop */
  };
  var classNames = /* @__PURE__ */ new WeakMap();
  var handler = {
    get(target, name) {
      return target[name];
    },
    set(target, name, value) {
      target[name] = value;
      return true;
    }
  };
  var SVGElement$1 = class SVGElement extends Element$1 {
    constructor(ownerDocument, localName, ownerSVGElement = null) {
      super(ownerDocument, localName);
      this.ownerSVGElement = ownerSVGElement;
    }
    get className() {
      if (!classNames.has(this))
        classNames.set(this, new Proxy({ baseVal: "", animVal: "" }, handler));
      return classNames.get(this);
    }
    /* c8 ignore start */
    set className(value) {
      const { classList } = this;
      classList.clear();
      classList.add(...$String(value).split(/\s+/));
    }
    /* c8 ignore stop */
    get namespaceURI() {
      return "http://www.w3.org/2000/svg";
    }
    getAttribute(name) {
      return name === "class" ? [...this.classList].join(" ") : super.getAttribute(name);
    }
    setAttribute(name, value) {
      if (name === "class")
        this.className = value;
      else if (name === "style") {
        const { className } = this;
        className.baseVal = className.animVal = value;
      }
      super.setAttribute(name, value);
    }
  };
  var illegalConstructor = () => {
    throw new TypeError("Illegal constructor");
  };
  function Attr2() {
    illegalConstructor();
  }
  setPrototypeOf(Attr2, Attr$1);
  Attr2.prototype = Attr$1.prototype;
  function CDATASection2() {
    illegalConstructor();
  }
  setPrototypeOf(CDATASection2, CDATASection$1);
  CDATASection2.prototype = CDATASection$1.prototype;
  function CharacterData2() {
    illegalConstructor();
  }
  setPrototypeOf(CharacterData2, CharacterData$1);
  CharacterData2.prototype = CharacterData$1.prototype;
  function Comment3() {
    illegalConstructor();
  }
  setPrototypeOf(Comment3, Comment$1);
  Comment3.prototype = Comment$1.prototype;
  function DocumentFragment2() {
    illegalConstructor();
  }
  setPrototypeOf(DocumentFragment2, DocumentFragment$1);
  DocumentFragment2.prototype = DocumentFragment$1.prototype;
  function DocumentType2() {
    illegalConstructor();
  }
  setPrototypeOf(DocumentType2, DocumentType$1);
  DocumentType2.prototype = DocumentType$1.prototype;
  function Element3() {
    illegalConstructor();
  }
  setPrototypeOf(Element3, Element$1);
  Element3.prototype = Element$1.prototype;
  function Node3() {
    illegalConstructor();
  }
  setPrototypeOf(Node3, Node$1);
  Node3.prototype = Node$1.prototype;
  function ShadowRoot2() {
    illegalConstructor();
  }
  setPrototypeOf(ShadowRoot2, ShadowRoot$1);
  ShadowRoot2.prototype = ShadowRoot$1.prototype;
  function Text3() {
    illegalConstructor();
  }
  setPrototypeOf(Text3, Text$1);
  Text3.prototype = Text$1.prototype;
  function SVGElement2() {
    illegalConstructor();
  }
  setPrototypeOf(SVGElement2, SVGElement$1);
  SVGElement2.prototype = SVGElement$1.prototype;
  var Facades = {
    Attr: Attr2,
    CDATASection: CDATASection2,
    CharacterData: CharacterData2,
    Comment: Comment3,
    DocumentFragment: DocumentFragment2,
    DocumentType: DocumentType2,
    Element: Element3,
    Node: Node3,
    ShadowRoot: ShadowRoot2,
    Text: Text3,
    SVGElement: SVGElement2
  };
  var Level0 = /* @__PURE__ */ new WeakMap();
  var level0 = {
    get(element, name) {
      return Level0.has(element) && Level0.get(element)[name] || null;
    },
    set(element, name, value) {
      if (!Level0.has(element))
        Level0.set(element, {});
      const handlers = Level0.get(element);
      const type = name.slice(2);
      if (handlers[name])
        element.removeEventListener(type, handlers[name], false);
      if (handlers[name] = value)
        element.addEventListener(type, value, false);
    }
  };
  var HTMLElement = class extends Element$1 {
    static get observedAttributes() {
      return [];
    }
    constructor(ownerDocument = null, localName = "") {
      super(ownerDocument, localName);
      const ownerLess = !ownerDocument;
      let options;
      if (ownerLess) {
        const { constructor: Class } = this;
        if (!Classes.has(Class))
          throw new Error("unable to initialize this Custom Element");
        ({ ownerDocument, localName, options } = Classes.get(Class));
      }
      if (ownerDocument[UPGRADE]) {
        const { element, values } = ownerDocument[UPGRADE];
        ownerDocument[UPGRADE] = null;
        for (const [key2, value] of values)
          element[key2] = value;
        return element;
      }
      if (ownerLess) {
        this.ownerDocument = this[END].ownerDocument = ownerDocument;
        this.localName = localName;
        customElements.set(this, { connected: false });
        if (options.is)
          this.setAttribute("is", options.is);
      }
    }
    /* c8 ignore start */
    /* TODO: what about these?
    offsetHeight
    offsetLeft
    offsetParent
    offsetTop
    offsetWidth
    */
    blur() {
      this.dispatchEvent(new GlobalEvent("blur"));
    }
    click() {
      const clickEvent = new GlobalEvent("click", { bubbles: true, cancelable: true });
      clickEvent.button = 0;
      this.dispatchEvent(clickEvent);
    }
    // Boolean getters
    get accessKeyLabel() {
      const { accessKey } = this;
      return accessKey && `Alt+Shift+${accessKey}`;
    }
    get isContentEditable() {
      return this.hasAttribute("contenteditable");
    }
    // Boolean Accessors
    get contentEditable() {
      return booleanAttribute.get(this, "contenteditable");
    }
    set contentEditable(value) {
      booleanAttribute.set(this, "contenteditable", value);
    }
    get draggable() {
      return booleanAttribute.get(this, "draggable");
    }
    set draggable(value) {
      booleanAttribute.set(this, "draggable", value);
    }
    get hidden() {
      return booleanAttribute.get(this, "hidden");
    }
    set hidden(value) {
      booleanAttribute.set(this, "hidden", value);
    }
    get spellcheck() {
      return booleanAttribute.get(this, "spellcheck");
    }
    set spellcheck(value) {
      booleanAttribute.set(this, "spellcheck", value);
    }
    // String Accessors
    get accessKey() {
      return stringAttribute.get(this, "accesskey");
    }
    set accessKey(value) {
      stringAttribute.set(this, "accesskey", value);
    }
    get dir() {
      return stringAttribute.get(this, "dir");
    }
    set dir(value) {
      stringAttribute.set(this, "dir", value);
    }
    get lang() {
      return stringAttribute.get(this, "lang");
    }
    set lang(value) {
      stringAttribute.set(this, "lang", value);
    }
    get title() {
      return stringAttribute.get(this, "title");
    }
    set title(value) {
      stringAttribute.set(this, "title", value);
    }
    // DOM Level 0
    get onabort() {
      return level0.get(this, "onabort");
    }
    set onabort(value) {
      level0.set(this, "onabort", value);
    }
    get onblur() {
      return level0.get(this, "onblur");
    }
    set onblur(value) {
      level0.set(this, "onblur", value);
    }
    get oncancel() {
      return level0.get(this, "oncancel");
    }
    set oncancel(value) {
      level0.set(this, "oncancel", value);
    }
    get oncanplay() {
      return level0.get(this, "oncanplay");
    }
    set oncanplay(value) {
      level0.set(this, "oncanplay", value);
    }
    get oncanplaythrough() {
      return level0.get(this, "oncanplaythrough");
    }
    set oncanplaythrough(value) {
      level0.set(this, "oncanplaythrough", value);
    }
    get onchange() {
      return level0.get(this, "onchange");
    }
    set onchange(value) {
      level0.set(this, "onchange", value);
    }
    get onclick() {
      return level0.get(this, "onclick");
    }
    set onclick(value) {
      level0.set(this, "onclick", value);
    }
    get onclose() {
      return level0.get(this, "onclose");
    }
    set onclose(value) {
      level0.set(this, "onclose", value);
    }
    get oncontextmenu() {
      return level0.get(this, "oncontextmenu");
    }
    set oncontextmenu(value) {
      level0.set(this, "oncontextmenu", value);
    }
    get oncuechange() {
      return level0.get(this, "oncuechange");
    }
    set oncuechange(value) {
      level0.set(this, "oncuechange", value);
    }
    get ondblclick() {
      return level0.get(this, "ondblclick");
    }
    set ondblclick(value) {
      level0.set(this, "ondblclick", value);
    }
    get ondrag() {
      return level0.get(this, "ondrag");
    }
    set ondrag(value) {
      level0.set(this, "ondrag", value);
    }
    get ondragend() {
      return level0.get(this, "ondragend");
    }
    set ondragend(value) {
      level0.set(this, "ondragend", value);
    }
    get ondragenter() {
      return level0.get(this, "ondragenter");
    }
    set ondragenter(value) {
      level0.set(this, "ondragenter", value);
    }
    get ondragleave() {
      return level0.get(this, "ondragleave");
    }
    set ondragleave(value) {
      level0.set(this, "ondragleave", value);
    }
    get ondragover() {
      return level0.get(this, "ondragover");
    }
    set ondragover(value) {
      level0.set(this, "ondragover", value);
    }
    get ondragstart() {
      return level0.get(this, "ondragstart");
    }
    set ondragstart(value) {
      level0.set(this, "ondragstart", value);
    }
    get ondrop() {
      return level0.get(this, "ondrop");
    }
    set ondrop(value) {
      level0.set(this, "ondrop", value);
    }
    get ondurationchange() {
      return level0.get(this, "ondurationchange");
    }
    set ondurationchange(value) {
      level0.set(this, "ondurationchange", value);
    }
    get onemptied() {
      return level0.get(this, "onemptied");
    }
    set onemptied(value) {
      level0.set(this, "onemptied", value);
    }
    get onended() {
      return level0.get(this, "onended");
    }
    set onended(value) {
      level0.set(this, "onended", value);
    }
    get onerror() {
      return level0.get(this, "onerror");
    }
    set onerror(value) {
      level0.set(this, "onerror", value);
    }
    get onfocus() {
      return level0.get(this, "onfocus");
    }
    set onfocus(value) {
      level0.set(this, "onfocus", value);
    }
    get oninput() {
      return level0.get(this, "oninput");
    }
    set oninput(value) {
      level0.set(this, "oninput", value);
    }
    get oninvalid() {
      return level0.get(this, "oninvalid");
    }
    set oninvalid(value) {
      level0.set(this, "oninvalid", value);
    }
    get onkeydown() {
      return level0.get(this, "onkeydown");
    }
    set onkeydown(value) {
      level0.set(this, "onkeydown", value);
    }
    get onkeypress() {
      return level0.get(this, "onkeypress");
    }
    set onkeypress(value) {
      level0.set(this, "onkeypress", value);
    }
    get onkeyup() {
      return level0.get(this, "onkeyup");
    }
    set onkeyup(value) {
      level0.set(this, "onkeyup", value);
    }
    get onload() {
      return level0.get(this, "onload");
    }
    set onload(value) {
      level0.set(this, "onload", value);
    }
    get onloadeddata() {
      return level0.get(this, "onloadeddata");
    }
    set onloadeddata(value) {
      level0.set(this, "onloadeddata", value);
    }
    get onloadedmetadata() {
      return level0.get(this, "onloadedmetadata");
    }
    set onloadedmetadata(value) {
      level0.set(this, "onloadedmetadata", value);
    }
    get onloadstart() {
      return level0.get(this, "onloadstart");
    }
    set onloadstart(value) {
      level0.set(this, "onloadstart", value);
    }
    get onmousedown() {
      return level0.get(this, "onmousedown");
    }
    set onmousedown(value) {
      level0.set(this, "onmousedown", value);
    }
    get onmouseenter() {
      return level0.get(this, "onmouseenter");
    }
    set onmouseenter(value) {
      level0.set(this, "onmouseenter", value);
    }
    get onmouseleave() {
      return level0.get(this, "onmouseleave");
    }
    set onmouseleave(value) {
      level0.set(this, "onmouseleave", value);
    }
    get onmousemove() {
      return level0.get(this, "onmousemove");
    }
    set onmousemove(value) {
      level0.set(this, "onmousemove", value);
    }
    get onmouseout() {
      return level0.get(this, "onmouseout");
    }
    set onmouseout(value) {
      level0.set(this, "onmouseout", value);
    }
    get onmouseover() {
      return level0.get(this, "onmouseover");
    }
    set onmouseover(value) {
      level0.set(this, "onmouseover", value);
    }
    get onmouseup() {
      return level0.get(this, "onmouseup");
    }
    set onmouseup(value) {
      level0.set(this, "onmouseup", value);
    }
    get onmousewheel() {
      return level0.get(this, "onmousewheel");
    }
    set onmousewheel(value) {
      level0.set(this, "onmousewheel", value);
    }
    get onpause() {
      return level0.get(this, "onpause");
    }
    set onpause(value) {
      level0.set(this, "onpause", value);
    }
    get onplay() {
      return level0.get(this, "onplay");
    }
    set onplay(value) {
      level0.set(this, "onplay", value);
    }
    get onplaying() {
      return level0.get(this, "onplaying");
    }
    set onplaying(value) {
      level0.set(this, "onplaying", value);
    }
    get onprogress() {
      return level0.get(this, "onprogress");
    }
    set onprogress(value) {
      level0.set(this, "onprogress", value);
    }
    get onratechange() {
      return level0.get(this, "onratechange");
    }
    set onratechange(value) {
      level0.set(this, "onratechange", value);
    }
    get onreset() {
      return level0.get(this, "onreset");
    }
    set onreset(value) {
      level0.set(this, "onreset", value);
    }
    get onresize() {
      return level0.get(this, "onresize");
    }
    set onresize(value) {
      level0.set(this, "onresize", value);
    }
    get onscroll() {
      return level0.get(this, "onscroll");
    }
    set onscroll(value) {
      level0.set(this, "onscroll", value);
    }
    get onseeked() {
      return level0.get(this, "onseeked");
    }
    set onseeked(value) {
      level0.set(this, "onseeked", value);
    }
    get onseeking() {
      return level0.get(this, "onseeking");
    }
    set onseeking(value) {
      level0.set(this, "onseeking", value);
    }
    get onselect() {
      return level0.get(this, "onselect");
    }
    set onselect(value) {
      level0.set(this, "onselect", value);
    }
    get onshow() {
      return level0.get(this, "onshow");
    }
    set onshow(value) {
      level0.set(this, "onshow", value);
    }
    get onstalled() {
      return level0.get(this, "onstalled");
    }
    set onstalled(value) {
      level0.set(this, "onstalled", value);
    }
    get onsubmit() {
      return level0.get(this, "onsubmit");
    }
    set onsubmit(value) {
      level0.set(this, "onsubmit", value);
    }
    get onsuspend() {
      return level0.get(this, "onsuspend");
    }
    set onsuspend(value) {
      level0.set(this, "onsuspend", value);
    }
    get ontimeupdate() {
      return level0.get(this, "ontimeupdate");
    }
    set ontimeupdate(value) {
      level0.set(this, "ontimeupdate", value);
    }
    get ontoggle() {
      return level0.get(this, "ontoggle");
    }
    set ontoggle(value) {
      level0.set(this, "ontoggle", value);
    }
    get onvolumechange() {
      return level0.get(this, "onvolumechange");
    }
    set onvolumechange(value) {
      level0.set(this, "onvolumechange", value);
    }
    get onwaiting() {
      return level0.get(this, "onwaiting");
    }
    set onwaiting(value) {
      level0.set(this, "onwaiting", value);
    }
    get onauxclick() {
      return level0.get(this, "onauxclick");
    }
    set onauxclick(value) {
      level0.set(this, "onauxclick", value);
    }
    get ongotpointercapture() {
      return level0.get(this, "ongotpointercapture");
    }
    set ongotpointercapture(value) {
      level0.set(this, "ongotpointercapture", value);
    }
    get onlostpointercapture() {
      return level0.get(this, "onlostpointercapture");
    }
    set onlostpointercapture(value) {
      level0.set(this, "onlostpointercapture", value);
    }
    get onpointercancel() {
      return level0.get(this, "onpointercancel");
    }
    set onpointercancel(value) {
      level0.set(this, "onpointercancel", value);
    }
    get onpointerdown() {
      return level0.get(this, "onpointerdown");
    }
    set onpointerdown(value) {
      level0.set(this, "onpointerdown", value);
    }
    get onpointerenter() {
      return level0.get(this, "onpointerenter");
    }
    set onpointerenter(value) {
      level0.set(this, "onpointerenter", value);
    }
    get onpointerleave() {
      return level0.get(this, "onpointerleave");
    }
    set onpointerleave(value) {
      level0.set(this, "onpointerleave", value);
    }
    get onpointermove() {
      return level0.get(this, "onpointermove");
    }
    set onpointermove(value) {
      level0.set(this, "onpointermove", value);
    }
    get onpointerout() {
      return level0.get(this, "onpointerout");
    }
    set onpointerout(value) {
      level0.set(this, "onpointerout", value);
    }
    get onpointerover() {
      return level0.get(this, "onpointerover");
    }
    set onpointerover(value) {
      level0.set(this, "onpointerover", value);
    }
    get onpointerup() {
      return level0.get(this, "onpointerup");
    }
    set onpointerup(value) {
      level0.set(this, "onpointerup", value);
    }
    /* c8 ignore stop */
  };
  var tagName$h = "template";
  var HTMLTemplateElement = class extends HTMLElement {
    constructor(ownerDocument) {
      super(ownerDocument, tagName$h);
      const content = this.ownerDocument.createDocumentFragment();
      (this[CONTENT] = content)[PRIVATE] = this;
    }
    get content() {
      if (this.hasChildNodes() && !this[CONTENT].hasChildNodes()) {
        for (const node of this.childNodes)
          this[CONTENT].appendChild(node.cloneNode(true));
      }
      return this[CONTENT];
    }
  };
  registerHTMLClass(tagName$h, HTMLTemplateElement);
  var HTMLHtmlElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "html") {
      super(ownerDocument, localName);
    }
  };
  var { toString } = HTMLElement.prototype;
  var TextElement = class extends HTMLElement {
    get innerHTML() {
      return this.textContent;
    }
    set innerHTML(html3) {
      this.textContent = html3;
    }
    toString() {
      const outerHTML = toString.call(this.cloneNode());
      return outerHTML.replace("><", () => `>${this.textContent}<`);
    }
  };
  var tagName$g = "script";
  var HTMLScriptElement = class extends TextElement {
    constructor(ownerDocument, localName = tagName$g) {
      super(ownerDocument, localName);
    }
    get type() {
      return stringAttribute.get(this, "type");
    }
    set type(value) {
      stringAttribute.set(this, "type", value);
    }
    get src() {
      return stringAttribute.get(this, "src");
    }
    set src(value) {
      stringAttribute.set(this, "src", value);
    }
    get defer() {
      return booleanAttribute.get(this, "defer");
    }
    set defer(value) {
      booleanAttribute.set(this, "defer", value);
    }
    get crossOrigin() {
      return stringAttribute.get(this, "crossorigin");
    }
    set crossOrigin(value) {
      stringAttribute.set(this, "crossorigin", value);
    }
    get nomodule() {
      return booleanAttribute.get(this, "nomodule");
    }
    set nomodule(value) {
      booleanAttribute.set(this, "nomodule", value);
    }
    get referrerPolicy() {
      return stringAttribute.get(this, "referrerpolicy");
    }
    set referrerPolicy(value) {
      stringAttribute.set(this, "referrerpolicy", value);
    }
    get nonce() {
      return stringAttribute.get(this, "nonce");
    }
    set nonce(value) {
      stringAttribute.set(this, "nonce", value);
    }
    get async() {
      return booleanAttribute.get(this, "async");
    }
    set async(value) {
      booleanAttribute.set(this, "async", value);
    }
    get text() {
      return this.textContent;
    }
    set text(content) {
      this.textContent = content;
    }
  };
  registerHTMLClass(tagName$g, HTMLScriptElement);
  var HTMLFrameElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "frame") {
      super(ownerDocument, localName);
    }
  };
  var tagName$f = "iframe";
  var HTMLIFrameElement = class extends HTMLElement {
    constructor(ownerDocument, localName = tagName$f) {
      super(ownerDocument, localName);
    }
    /* c8 ignore start */
    get src() {
      return stringAttribute.get(this, "src");
    }
    set src(value) {
      stringAttribute.set(this, "src", value);
    }
    get srcdoc() {
      return stringAttribute.get(this, "srcdoc");
    }
    set srcdoc(value) {
      stringAttribute.set(this, "srcdoc", value);
    }
    get name() {
      return stringAttribute.get(this, "name");
    }
    set name(value) {
      stringAttribute.set(this, "name", value);
    }
    get allow() {
      return stringAttribute.get(this, "allow");
    }
    set allow(value) {
      stringAttribute.set(this, "allow", value);
    }
    get allowFullscreen() {
      return booleanAttribute.get(this, "allowfullscreen");
    }
    set allowFullscreen(value) {
      booleanAttribute.set(this, "allowfullscreen", value);
    }
    get referrerPolicy() {
      return stringAttribute.get(this, "referrerpolicy");
    }
    set referrerPolicy(value) {
      stringAttribute.set(this, "referrerpolicy", value);
    }
    get loading() {
      return stringAttribute.get(this, "loading");
    }
    set loading(value) {
      stringAttribute.set(this, "loading", value);
    }
    /* c8 ignore stop */
  };
  registerHTMLClass(tagName$f, HTMLIFrameElement);
  var HTMLObjectElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "object") {
      super(ownerDocument, localName);
    }
  };
  var HTMLHeadElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "head") {
      super(ownerDocument, localName);
    }
  };
  var HTMLBodyElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "body") {
      super(ownerDocument, localName);
    }
  };
  var lib = {};
  var CSSStyleDeclaration2 = {};
  var parse$1 = {};
  var CSSStyleSheet = {};
  var StyleSheet = {};
  var hasRequiredStyleSheet;
  function requireStyleSheet() {
    if (hasRequiredStyleSheet) return StyleSheet;
    hasRequiredStyleSheet = 1;
    var CSSOM = {};
    CSSOM.StyleSheet = function StyleSheet2() {
      this.parentStyleSheet = null;
    };
    StyleSheet.StyleSheet = CSSOM.StyleSheet;
    return StyleSheet;
  }
  var CSSStyleRule = {};
  var CSSRule = {};
  var hasRequiredCSSRule;
  function requireCSSRule() {
    if (hasRequiredCSSRule) return CSSRule;
    hasRequiredCSSRule = 1;
    var CSSOM = {};
    CSSOM.CSSRule = function CSSRule2() {
      this.parentRule = null;
      this.parentStyleSheet = null;
    };
    CSSOM.CSSRule.UNKNOWN_RULE = 0;
    CSSOM.CSSRule.STYLE_RULE = 1;
    CSSOM.CSSRule.CHARSET_RULE = 2;
    CSSOM.CSSRule.IMPORT_RULE = 3;
    CSSOM.CSSRule.MEDIA_RULE = 4;
    CSSOM.CSSRule.FONT_FACE_RULE = 5;
    CSSOM.CSSRule.PAGE_RULE = 6;
    CSSOM.CSSRule.KEYFRAMES_RULE = 7;
    CSSOM.CSSRule.KEYFRAME_RULE = 8;
    CSSOM.CSSRule.MARGIN_RULE = 9;
    CSSOM.CSSRule.NAMESPACE_RULE = 10;
    CSSOM.CSSRule.COUNTER_STYLE_RULE = 11;
    CSSOM.CSSRule.SUPPORTS_RULE = 12;
    CSSOM.CSSRule.DOCUMENT_RULE = 13;
    CSSOM.CSSRule.FONT_FEATURE_VALUES_RULE = 14;
    CSSOM.CSSRule.VIEWPORT_RULE = 15;
    CSSOM.CSSRule.REGION_STYLE_RULE = 16;
    CSSOM.CSSRule.prototype = {
      constructor: CSSOM.CSSRule
      //FIXME
    };
    CSSRule.CSSRule = CSSOM.CSSRule;
    return CSSRule;
  }
  var hasRequiredCSSStyleRule;
  function requireCSSStyleRule() {
    if (hasRequiredCSSStyleRule) return CSSStyleRule;
    hasRequiredCSSStyleRule = 1;
    var CSSOM = {
      CSSStyleDeclaration: requireCSSStyleDeclaration().CSSStyleDeclaration,
      CSSRule: requireCSSRule().CSSRule
    };
    CSSOM.CSSStyleRule = function CSSStyleRule2() {
      CSSOM.CSSRule.call(this);
      this.selectorText = "";
      this.style = new CSSOM.CSSStyleDeclaration();
      this.style.parentRule = this;
    };
    CSSOM.CSSStyleRule.prototype = new CSSOM.CSSRule();
    CSSOM.CSSStyleRule.prototype.constructor = CSSOM.CSSStyleRule;
    CSSOM.CSSStyleRule.prototype.type = 1;
    Object.defineProperty(CSSOM.CSSStyleRule.prototype, "cssText", {
      get: function() {
        var text3;
        if (this.selectorText) {
          text3 = this.selectorText + " {" + this.style.cssText + "}";
        } else {
          text3 = "";
        }
        return text3;
      },
      set: function(cssText) {
        var rule = CSSOM.CSSStyleRule.parse(cssText);
        this.style = rule.style;
        this.selectorText = rule.selectorText;
      }
    });
    CSSOM.CSSStyleRule.parse = function(ruleText) {
      var i = 0;
      var state = "selector";
      var index2;
      var j = i;
      var buffer = "";
      var SIGNIFICANT_WHITESPACE = {
        "selector": true,
        "value": true
      };
      var styleRule = new CSSOM.CSSStyleRule();
      var name, priority = "";
      for (var character; character = ruleText.charAt(i); i++) {
        switch (character) {
          case " ":
          case "	":
          case "\r":
          case "\n":
          case "\f":
            if (SIGNIFICANT_WHITESPACE[state]) {
              switch (ruleText.charAt(i - 1)) {
                case " ":
                case "	":
                case "\r":
                case "\n":
                case "\f":
                  break;
                default:
                  buffer += " ";
                  break;
              }
            }
            break;
          // String
          case '"':
            j = i + 1;
            index2 = ruleText.indexOf('"', j) + 1;
            if (!index2) {
              throw '" is missing';
            }
            buffer += ruleText.slice(i, index2);
            i = index2 - 1;
            break;
          case "'":
            j = i + 1;
            index2 = ruleText.indexOf("'", j) + 1;
            if (!index2) {
              throw "' is missing";
            }
            buffer += ruleText.slice(i, index2);
            i = index2 - 1;
            break;
          // Comment
          case "/":
            if (ruleText.charAt(i + 1) === "*") {
              i += 2;
              index2 = ruleText.indexOf("*/", i);
              if (index2 === -1) {
                throw new SyntaxError("Missing */");
              } else {
                i = index2 + 1;
              }
            } else {
              buffer += character;
            }
            break;
          case "{":
            if (state === "selector") {
              styleRule.selectorText = buffer.trim();
              buffer = "";
              state = "name";
            }
            break;
          case ":":
            if (state === "name") {
              name = buffer.trim();
              buffer = "";
              state = "value";
            } else {
              buffer += character;
            }
            break;
          case "!":
            if (state === "value" && ruleText.indexOf("!important", i) === i) {
              priority = "important";
              i += "important".length;
            } else {
              buffer += character;
            }
            break;
          case ";":
            if (state === "value") {
              styleRule.style.setProperty(name, buffer.trim(), priority);
              priority = "";
              buffer = "";
              state = "name";
            } else {
              buffer += character;
            }
            break;
          case "}":
            if (state === "value") {
              styleRule.style.setProperty(name, buffer.trim(), priority);
              priority = "";
              buffer = "";
            } else if (state === "name") {
              break;
            } else {
              buffer += character;
            }
            state = "selector";
            break;
          default:
            buffer += character;
            break;
        }
      }
      return styleRule;
    };
    CSSStyleRule.CSSStyleRule = CSSOM.CSSStyleRule;
    return CSSStyleRule;
  }
  var hasRequiredCSSStyleSheet;
  function requireCSSStyleSheet() {
    if (hasRequiredCSSStyleSheet) return CSSStyleSheet;
    hasRequiredCSSStyleSheet = 1;
    var CSSOM = {
      StyleSheet: requireStyleSheet().StyleSheet,
      CSSStyleRule: requireCSSStyleRule().CSSStyleRule
    };
    CSSOM.CSSStyleSheet = function CSSStyleSheet2() {
      CSSOM.StyleSheet.call(this);
      this.cssRules = [];
    };
    CSSOM.CSSStyleSheet.prototype = new CSSOM.StyleSheet();
    CSSOM.CSSStyleSheet.prototype.constructor = CSSOM.CSSStyleSheet;
    CSSOM.CSSStyleSheet.prototype.insertRule = function(rule, index2) {
      if (index2 < 0 || index2 > this.cssRules.length) {
        throw new RangeError("INDEX_SIZE_ERR");
      }
      var cssRule = CSSOM.parse(rule).cssRules[0];
      cssRule.parentStyleSheet = this;
      this.cssRules.splice(index2, 0, cssRule);
      return index2;
    };
    CSSOM.CSSStyleSheet.prototype.deleteRule = function(index2) {
      if (index2 < 0 || index2 >= this.cssRules.length) {
        throw new RangeError("INDEX_SIZE_ERR");
      }
      this.cssRules.splice(index2, 1);
    };
    CSSOM.CSSStyleSheet.prototype.toString = function() {
      var result = "";
      var rules = this.cssRules;
      for (var i = 0; i < rules.length; i++) {
        result += rules[i].cssText + "\n";
      }
      return result;
    };
    CSSStyleSheet.CSSStyleSheet = CSSOM.CSSStyleSheet;
    CSSOM.parse = requireParse().parse;
    return CSSStyleSheet;
  }
  var CSSImportRule = {};
  var MediaList = {};
  var hasRequiredMediaList;
  function requireMediaList() {
    if (hasRequiredMediaList) return MediaList;
    hasRequiredMediaList = 1;
    var CSSOM = {};
    CSSOM.MediaList = function MediaList2() {
      this.length = 0;
    };
    CSSOM.MediaList.prototype = {
      constructor: CSSOM.MediaList,
      /**
       * @return {string}
       */
      get mediaText() {
        return Array.prototype.join.call(this, ", ");
      },
      /**
       * @param {string} value
       */
      set mediaText(value) {
        var values = value.split(",");
        var length = this.length = values.length;
        for (var i = 0; i < length; i++) {
          this[i] = values[i].trim();
        }
      },
      /**
       * @param {string} medium
       */
      appendMedium: function(medium) {
        if (Array.prototype.indexOf.call(this, medium) === -1) {
          this[this.length] = medium;
          this.length++;
        }
      },
      /**
       * @param {string} medium
       */
      deleteMedium: function(medium) {
        var index2 = Array.prototype.indexOf.call(this, medium);
        if (index2 !== -1) {
          Array.prototype.splice.call(this, index2, 1);
        }
      }
    };
    MediaList.MediaList = CSSOM.MediaList;
    return MediaList;
  }
  var hasRequiredCSSImportRule;
  function requireCSSImportRule() {
    if (hasRequiredCSSImportRule) return CSSImportRule;
    hasRequiredCSSImportRule = 1;
    var CSSOM = {
      CSSRule: requireCSSRule().CSSRule,
      CSSStyleSheet: requireCSSStyleSheet().CSSStyleSheet,
      MediaList: requireMediaList().MediaList
    };
    CSSOM.CSSImportRule = function CSSImportRule2() {
      CSSOM.CSSRule.call(this);
      this.href = "";
      this.media = new CSSOM.MediaList();
      this.styleSheet = new CSSOM.CSSStyleSheet();
    };
    CSSOM.CSSImportRule.prototype = new CSSOM.CSSRule();
    CSSOM.CSSImportRule.prototype.constructor = CSSOM.CSSImportRule;
    CSSOM.CSSImportRule.prototype.type = 3;
    Object.defineProperty(CSSOM.CSSImportRule.prototype, "cssText", {
      get: function() {
        var mediaText = this.media.mediaText;
        return "@import url(" + this.href + ")" + (mediaText ? " " + mediaText : "") + ";";
      },
      set: function(cssText) {
        var i = 0;
        var state = "";
        var buffer = "";
        var index2;
        for (var character; character = cssText.charAt(i); i++) {
          switch (character) {
            case " ":
            case "	":
            case "\r":
            case "\n":
            case "\f":
              if (state === "after-import") {
                state = "url";
              } else {
                buffer += character;
              }
              break;
            case "@":
              if (!state && cssText.indexOf("@import", i) === i) {
                state = "after-import";
                i += "import".length;
                buffer = "";
              }
              break;
            case "u":
              if (state === "url" && cssText.indexOf("url(", i) === i) {
                index2 = cssText.indexOf(")", i + 1);
                if (index2 === -1) {
                  throw i + ': ")" not found';
                }
                i += "url(".length;
                var url = cssText.slice(i, index2);
                if (url[0] === url[url.length - 1]) {
                  if (url[0] === '"' || url[0] === "'") {
                    url = url.slice(1, -1);
                  }
                }
                this.href = url;
                i = index2;
                state = "media";
              }
              break;
            case '"':
              if (state === "url") {
                index2 = cssText.indexOf('"', i + 1);
                if (!index2) {
                  throw i + `: '"' not found`;
                }
                this.href = cssText.slice(i + 1, index2);
                i = index2;
                state = "media";
              }
              break;
            case "'":
              if (state === "url") {
                index2 = cssText.indexOf("'", i + 1);
                if (!index2) {
                  throw i + `: "'" not found`;
                }
                this.href = cssText.slice(i + 1, index2);
                i = index2;
                state = "media";
              }
              break;
            case ";":
              if (state === "media") {
                if (buffer) {
                  this.media.mediaText = buffer.trim();
                }
              }
              break;
            default:
              if (state === "media") {
                buffer += character;
              }
              break;
          }
        }
      }
    });
    CSSImportRule.CSSImportRule = CSSOM.CSSImportRule;
    return CSSImportRule;
  }
  var CSSGroupingRule = {};
  var hasRequiredCSSGroupingRule;
  function requireCSSGroupingRule() {
    if (hasRequiredCSSGroupingRule) return CSSGroupingRule;
    hasRequiredCSSGroupingRule = 1;
    var CSSOM = {
      CSSRule: requireCSSRule().CSSRule
    };
    CSSOM.CSSGroupingRule = function CSSGroupingRule2() {
      CSSOM.CSSRule.call(this);
      this.cssRules = [];
    };
    CSSOM.CSSGroupingRule.prototype = new CSSOM.CSSRule();
    CSSOM.CSSGroupingRule.prototype.constructor = CSSOM.CSSGroupingRule;
    CSSOM.CSSGroupingRule.prototype.insertRule = function insertRule(rule, index2) {
      if (index2 < 0 || index2 > this.cssRules.length) {
        throw new RangeError("INDEX_SIZE_ERR");
      }
      var cssRule = CSSOM.parse(rule).cssRules[0];
      cssRule.parentRule = this;
      this.cssRules.splice(index2, 0, cssRule);
      return index2;
    };
    CSSOM.CSSGroupingRule.prototype.deleteRule = function deleteRule(index2) {
      if (index2 < 0 || index2 >= this.cssRules.length) {
        throw new RangeError("INDEX_SIZE_ERR");
      }
      this.cssRules.splice(index2, 1)[0].parentRule = null;
    };
    CSSGroupingRule.CSSGroupingRule = CSSOM.CSSGroupingRule;
    return CSSGroupingRule;
  }
  var CSSMediaRule = {};
  var CSSConditionRule = {};
  var hasRequiredCSSConditionRule;
  function requireCSSConditionRule() {
    if (hasRequiredCSSConditionRule) return CSSConditionRule;
    hasRequiredCSSConditionRule = 1;
    var CSSOM = {
      CSSRule: requireCSSRule().CSSRule,
      CSSGroupingRule: requireCSSGroupingRule().CSSGroupingRule
    };
    CSSOM.CSSConditionRule = function CSSConditionRule2() {
      CSSOM.CSSGroupingRule.call(this);
      this.cssRules = [];
    };
    CSSOM.CSSConditionRule.prototype = new CSSOM.CSSGroupingRule();
    CSSOM.CSSConditionRule.prototype.constructor = CSSOM.CSSConditionRule;
    CSSOM.CSSConditionRule.prototype.conditionText = "";
    CSSOM.CSSConditionRule.prototype.cssText = "";
    CSSConditionRule.CSSConditionRule = CSSOM.CSSConditionRule;
    return CSSConditionRule;
  }
  var hasRequiredCSSMediaRule;
  function requireCSSMediaRule() {
    if (hasRequiredCSSMediaRule) return CSSMediaRule;
    hasRequiredCSSMediaRule = 1;
    var CSSOM = {
      CSSRule: requireCSSRule().CSSRule,
      CSSGroupingRule: requireCSSGroupingRule().CSSGroupingRule,
      CSSConditionRule: requireCSSConditionRule().CSSConditionRule,
      MediaList: requireMediaList().MediaList
    };
    CSSOM.CSSMediaRule = function CSSMediaRule2() {
      CSSOM.CSSConditionRule.call(this);
      this.media = new CSSOM.MediaList();
    };
    CSSOM.CSSMediaRule.prototype = new CSSOM.CSSConditionRule();
    CSSOM.CSSMediaRule.prototype.constructor = CSSOM.CSSMediaRule;
    CSSOM.CSSMediaRule.prototype.type = 4;
    Object.defineProperties(CSSOM.CSSMediaRule.prototype, {
      "conditionText": {
        get: function() {
          return this.media.mediaText;
        },
        set: function(value) {
          this.media.mediaText = value;
        },
        configurable: true,
        enumerable: true
      },
      "cssText": {
        get: function() {
          var cssTexts = [];
          for (var i = 0, length = this.cssRules.length; i < length; i++) {
            cssTexts.push(this.cssRules[i].cssText);
          }
          return "@media " + this.media.mediaText + " {" + cssTexts.join("") + "}";
        },
        configurable: true,
        enumerable: true
      }
    });
    CSSMediaRule.CSSMediaRule = CSSOM.CSSMediaRule;
    return CSSMediaRule;
  }
  var CSSSupportsRule = {};
  var hasRequiredCSSSupportsRule;
  function requireCSSSupportsRule() {
    if (hasRequiredCSSSupportsRule) return CSSSupportsRule;
    hasRequiredCSSSupportsRule = 1;
    var CSSOM = {
      CSSRule: requireCSSRule().CSSRule,
      CSSGroupingRule: requireCSSGroupingRule().CSSGroupingRule,
      CSSConditionRule: requireCSSConditionRule().CSSConditionRule
    };
    CSSOM.CSSSupportsRule = function CSSSupportsRule2() {
      CSSOM.CSSConditionRule.call(this);
    };
    CSSOM.CSSSupportsRule.prototype = new CSSOM.CSSConditionRule();
    CSSOM.CSSSupportsRule.prototype.constructor = CSSOM.CSSSupportsRule;
    CSSOM.CSSSupportsRule.prototype.type = 12;
    Object.defineProperty(CSSOM.CSSSupportsRule.prototype, "cssText", {
      get: function() {
        var cssTexts = [];
        for (var i = 0, length = this.cssRules.length; i < length; i++) {
          cssTexts.push(this.cssRules[i].cssText);
        }
        return "@supports " + this.conditionText + " {" + cssTexts.join("") + "}";
      }
    });
    CSSSupportsRule.CSSSupportsRule = CSSOM.CSSSupportsRule;
    return CSSSupportsRule;
  }
  var CSSFontFaceRule = {};
  var hasRequiredCSSFontFaceRule;
  function requireCSSFontFaceRule() {
    if (hasRequiredCSSFontFaceRule) return CSSFontFaceRule;
    hasRequiredCSSFontFaceRule = 1;
    var CSSOM = {
      CSSStyleDeclaration: requireCSSStyleDeclaration().CSSStyleDeclaration,
      CSSRule: requireCSSRule().CSSRule
    };
    CSSOM.CSSFontFaceRule = function CSSFontFaceRule2() {
      CSSOM.CSSRule.call(this);
      this.style = new CSSOM.CSSStyleDeclaration();
      this.style.parentRule = this;
    };
    CSSOM.CSSFontFaceRule.prototype = new CSSOM.CSSRule();
    CSSOM.CSSFontFaceRule.prototype.constructor = CSSOM.CSSFontFaceRule;
    CSSOM.CSSFontFaceRule.prototype.type = 5;
    Object.defineProperty(CSSOM.CSSFontFaceRule.prototype, "cssText", {
      get: function() {
        return "@font-face {" + this.style.cssText + "}";
      }
    });
    CSSFontFaceRule.CSSFontFaceRule = CSSOM.CSSFontFaceRule;
    return CSSFontFaceRule;
  }
  var CSSHostRule = {};
  var hasRequiredCSSHostRule;
  function requireCSSHostRule() {
    if (hasRequiredCSSHostRule) return CSSHostRule;
    hasRequiredCSSHostRule = 1;
    var CSSOM = {
      CSSRule: requireCSSRule().CSSRule
    };
    CSSOM.CSSHostRule = function CSSHostRule2() {
      CSSOM.CSSRule.call(this);
      this.cssRules = [];
    };
    CSSOM.CSSHostRule.prototype = new CSSOM.CSSRule();
    CSSOM.CSSHostRule.prototype.constructor = CSSOM.CSSHostRule;
    CSSOM.CSSHostRule.prototype.type = 1001;
    Object.defineProperty(CSSOM.CSSHostRule.prototype, "cssText", {
      get: function() {
        var cssTexts = [];
        for (var i = 0, length = this.cssRules.length; i < length; i++) {
          cssTexts.push(this.cssRules[i].cssText);
        }
        return "@host {" + cssTexts.join("") + "}";
      }
    });
    CSSHostRule.CSSHostRule = CSSOM.CSSHostRule;
    return CSSHostRule;
  }
  var CSSKeyframeRule = {};
  var hasRequiredCSSKeyframeRule;
  function requireCSSKeyframeRule() {
    if (hasRequiredCSSKeyframeRule) return CSSKeyframeRule;
    hasRequiredCSSKeyframeRule = 1;
    var CSSOM = {
      CSSRule: requireCSSRule().CSSRule,
      CSSStyleDeclaration: requireCSSStyleDeclaration().CSSStyleDeclaration
    };
    CSSOM.CSSKeyframeRule = function CSSKeyframeRule2() {
      CSSOM.CSSRule.call(this);
      this.keyText = "";
      this.style = new CSSOM.CSSStyleDeclaration();
      this.style.parentRule = this;
    };
    CSSOM.CSSKeyframeRule.prototype = new CSSOM.CSSRule();
    CSSOM.CSSKeyframeRule.prototype.constructor = CSSOM.CSSKeyframeRule;
    CSSOM.CSSKeyframeRule.prototype.type = 8;
    Object.defineProperty(CSSOM.CSSKeyframeRule.prototype, "cssText", {
      get: function() {
        return this.keyText + " {" + this.style.cssText + "} ";
      }
    });
    CSSKeyframeRule.CSSKeyframeRule = CSSOM.CSSKeyframeRule;
    return CSSKeyframeRule;
  }
  var CSSKeyframesRule = {};
  var hasRequiredCSSKeyframesRule;
  function requireCSSKeyframesRule() {
    if (hasRequiredCSSKeyframesRule) return CSSKeyframesRule;
    hasRequiredCSSKeyframesRule = 1;
    var CSSOM = {
      CSSRule: requireCSSRule().CSSRule
    };
    CSSOM.CSSKeyframesRule = function CSSKeyframesRule2() {
      CSSOM.CSSRule.call(this);
      this.name = "";
      this.cssRules = [];
    };
    CSSOM.CSSKeyframesRule.prototype = new CSSOM.CSSRule();
    CSSOM.CSSKeyframesRule.prototype.constructor = CSSOM.CSSKeyframesRule;
    CSSOM.CSSKeyframesRule.prototype.type = 7;
    Object.defineProperty(CSSOM.CSSKeyframesRule.prototype, "cssText", {
      get: function() {
        var cssTexts = [];
        for (var i = 0, length = this.cssRules.length; i < length; i++) {
          cssTexts.push("  " + this.cssRules[i].cssText);
        }
        return "@" + (this._vendorPrefix || "") + "keyframes " + this.name + " { \n" + cssTexts.join("\n") + "\n}";
      }
    });
    CSSKeyframesRule.CSSKeyframesRule = CSSOM.CSSKeyframesRule;
    return CSSKeyframesRule;
  }
  var CSSValueExpression = {};
  var CSSValue = {};
  var hasRequiredCSSValue;
  function requireCSSValue() {
    if (hasRequiredCSSValue) return CSSValue;
    hasRequiredCSSValue = 1;
    var CSSOM = {};
    CSSOM.CSSValue = function CSSValue2() {
    };
    CSSOM.CSSValue.prototype = {
      constructor: CSSOM.CSSValue,
      // @see: http://www.w3.org/TR/DOM-Level-2-Style/css.html#CSS-CSSValue
      set cssText(text3) {
        var name = this._getConstructorName();
        throw new Error('DOMException: property "cssText" of "' + name + '" is readonly and can not be replaced with "' + text3 + '"!');
      },
      get cssText() {
        var name = this._getConstructorName();
        throw new Error('getter "cssText" of "' + name + '" is not implemented!');
      },
      _getConstructorName: function() {
        var s = this.constructor.toString(), c = s.match(/function\s([^\(]+)/), name = c[1];
        return name;
      }
    };
    CSSValue.CSSValue = CSSOM.CSSValue;
    return CSSValue;
  }
  var hasRequiredCSSValueExpression;
  function requireCSSValueExpression() {
    if (hasRequiredCSSValueExpression) return CSSValueExpression;
    hasRequiredCSSValueExpression = 1;
    var CSSOM = {
      CSSValue: requireCSSValue().CSSValue
    };
    CSSOM.CSSValueExpression = function CSSValueExpression2(token, idx) {
      this._token = token;
      this._idx = idx;
    };
    CSSOM.CSSValueExpression.prototype = new CSSOM.CSSValue();
    CSSOM.CSSValueExpression.prototype.constructor = CSSOM.CSSValueExpression;
    CSSOM.CSSValueExpression.prototype.parse = function() {
      var token = this._token, idx = this._idx;
      var character = "", expression = "", error = "", info, paren = [];
      for (; ; ++idx) {
        character = token.charAt(idx);
        if (character === "") {
          error = "css expression error: unfinished expression!";
          break;
        }
        switch (character) {
          case "(":
            paren.push(character);
            expression += character;
            break;
          case ")":
            paren.pop(character);
            expression += character;
            break;
          case "/":
            if (info = this._parseJSComment(token, idx)) {
              if (info.error) {
                error = "css expression error: unfinished comment in expression!";
              } else {
                idx = info.idx;
              }
            } else if (info = this._parseJSRexExp(token, idx)) {
              idx = info.idx;
              expression += info.text;
            } else {
              expression += character;
            }
            break;
          case "'":
          case '"':
            info = this._parseJSString(token, idx, character);
            if (info) {
              idx = info.idx;
              expression += info.text;
            } else {
              expression += character;
            }
            break;
          default:
            expression += character;
            break;
        }
        if (error) {
          break;
        }
        if (paren.length === 0) {
          break;
        }
      }
      var ret;
      if (error) {
        ret = {
          error
        };
      } else {
        ret = {
          idx,
          expression
        };
      }
      return ret;
    };
    CSSOM.CSSValueExpression.prototype._parseJSComment = function(token, idx) {
      var nextChar = token.charAt(idx + 1), text3;
      if (nextChar === "/" || nextChar === "*") {
        var startIdx = idx, endIdx, commentEndChar;
        if (nextChar === "/") {
          commentEndChar = "\n";
        } else if (nextChar === "*") {
          commentEndChar = "*/";
        }
        endIdx = token.indexOf(commentEndChar, startIdx + 1 + 1);
        if (endIdx !== -1) {
          endIdx = endIdx + commentEndChar.length - 1;
          text3 = token.substring(idx, endIdx + 1);
          return {
            idx: endIdx,
            text: text3
          };
        } else {
          var error = "css expression error: unfinished comment in expression!";
          return {
            error
          };
        }
      } else {
        return false;
      }
    };
    CSSOM.CSSValueExpression.prototype._parseJSString = function(token, idx, sep) {
      var endIdx = this._findMatchedIdx(token, idx, sep), text3;
      if (endIdx === -1) {
        return false;
      } else {
        text3 = token.substring(idx, endIdx + sep.length);
        return {
          idx: endIdx,
          text: text3
        };
      }
    };
    CSSOM.CSSValueExpression.prototype._parseJSRexExp = function(token, idx) {
      var before2 = token.substring(0, idx).replace(/\s+$/, ""), legalRegx = [
        /^$/,
        /\($/,
        /\[$/,
        /\!$/,
        /\+$/,
        /\-$/,
        /\*$/,
        /\/\s+/,
        /\%$/,
        /\=$/,
        /\>$/,
        /<$/,
        /\&$/,
        /\|$/,
        /\^$/,
        /\~$/,
        /\?$/,
        /\,$/,
        /delete$/,
        /in$/,
        /instanceof$/,
        /new$/,
        /typeof$/,
        /void$/
      ];
      var isLegal = legalRegx.some(function(reg) {
        return reg.test(before2);
      });
      if (!isLegal) {
        return false;
      } else {
        var sep = "/";
        return this._parseJSString(token, idx, sep);
      }
    };
    CSSOM.CSSValueExpression.prototype._findMatchedIdx = function(token, idx, sep) {
      var startIdx = idx, endIdx;
      var NOT_FOUND = -1;
      while (true) {
        endIdx = token.indexOf(sep, startIdx + 1);
        if (endIdx === -1) {
          endIdx = NOT_FOUND;
          break;
        } else {
          var text3 = token.substring(idx + 1, endIdx), matched = text3.match(/\\+$/);
          if (!matched || matched[0] % 2 === 0) {
            break;
          } else {
            startIdx = endIdx;
          }
        }
      }
      var nextNewLineIdx = token.indexOf("\n", idx + 1);
      if (nextNewLineIdx < endIdx) {
        endIdx = NOT_FOUND;
      }
      return endIdx;
    };
    CSSValueExpression.CSSValueExpression = CSSOM.CSSValueExpression;
    return CSSValueExpression;
  }
  var CSSDocumentRule = {};
  var MatcherList = {};
  var hasRequiredMatcherList;
  function requireMatcherList() {
    if (hasRequiredMatcherList) return MatcherList;
    hasRequiredMatcherList = 1;
    var CSSOM = {};
    CSSOM.MatcherList = function MatcherList2() {
      this.length = 0;
    };
    CSSOM.MatcherList.prototype = {
      constructor: CSSOM.MatcherList,
      /**
       * @return {string}
       */
      get matcherText() {
        return Array.prototype.join.call(this, ", ");
      },
      /**
       * @param {string} value
       */
      set matcherText(value) {
        var values = value.split(",");
        var length = this.length = values.length;
        for (var i = 0; i < length; i++) {
          this[i] = values[i].trim();
        }
      },
      /**
       * @param {string} matcher
       */
      appendMatcher: function(matcher) {
        if (Array.prototype.indexOf.call(this, matcher) === -1) {
          this[this.length] = matcher;
          this.length++;
        }
      },
      /**
       * @param {string} matcher
       */
      deleteMatcher: function(matcher) {
        var index2 = Array.prototype.indexOf.call(this, matcher);
        if (index2 !== -1) {
          Array.prototype.splice.call(this, index2, 1);
        }
      }
    };
    MatcherList.MatcherList = CSSOM.MatcherList;
    return MatcherList;
  }
  var hasRequiredCSSDocumentRule;
  function requireCSSDocumentRule() {
    if (hasRequiredCSSDocumentRule) return CSSDocumentRule;
    hasRequiredCSSDocumentRule = 1;
    var CSSOM = {
      CSSRule: requireCSSRule().CSSRule,
      MatcherList: requireMatcherList().MatcherList
    };
    CSSOM.CSSDocumentRule = function CSSDocumentRule2() {
      CSSOM.CSSRule.call(this);
      this.matcher = new CSSOM.MatcherList();
      this.cssRules = [];
    };
    CSSOM.CSSDocumentRule.prototype = new CSSOM.CSSRule();
    CSSOM.CSSDocumentRule.prototype.constructor = CSSOM.CSSDocumentRule;
    CSSOM.CSSDocumentRule.prototype.type = 10;
    Object.defineProperty(CSSOM.CSSDocumentRule.prototype, "cssText", {
      get: function() {
        var cssTexts = [];
        for (var i = 0, length = this.cssRules.length; i < length; i++) {
          cssTexts.push(this.cssRules[i].cssText);
        }
        return "@-moz-document " + this.matcher.matcherText + " {" + cssTexts.join("") + "}";
      }
    });
    CSSDocumentRule.CSSDocumentRule = CSSOM.CSSDocumentRule;
    return CSSDocumentRule;
  }
  var hasRequiredParse;
  function requireParse() {
    if (hasRequiredParse) return parse$1;
    hasRequiredParse = 1;
    var CSSOM = {};
    CSSOM.parse = function parse2(token) {
      var i = 0;
      var state = "before-selector";
      var index2;
      var buffer = "";
      var valueParenthesisDepth = 0;
      var SIGNIFICANT_WHITESPACE = {
        "selector": true,
        "value": true,
        "value-parenthesis": true,
        "atRule": true,
        "importRule-begin": true,
        "importRule": true,
        "atBlock": true,
        "conditionBlock": true,
        "documentRule-begin": true
      };
      var styleSheet = new CSSOM.CSSStyleSheet();
      var currentScope = styleSheet;
      var parentRule;
      var ancestorRules = [];
      var hasAncestors = false;
      var prevScope;
      var name, priority = "", styleRule, mediaRule, supportsRule, importRule, fontFaceRule, keyframesRule, documentRule, hostRule;
      var atKeyframesRegExp = /@(-(?:\w+-)+)?keyframes/g;
      var parseError = function(message) {
        var lines3 = token.substring(0, i).split("\n");
        var lineCount = lines3.length;
        var charCount = lines3.pop().length + 1;
        var error = new Error(message + " (line " + lineCount + ", char " + charCount + ")");
        error.line = lineCount;
        error["char"] = charCount;
        error.styleSheet = styleSheet;
        throw error;
      };
      for (var character; character = token.charAt(i); i++) {
        switch (character) {
          case " ":
          case "	":
          case "\r":
          case "\n":
          case "\f":
            if (SIGNIFICANT_WHITESPACE[state]) {
              buffer += character;
            }
            break;
          // String
          case '"':
            index2 = i + 1;
            do {
              index2 = token.indexOf('"', index2) + 1;
              if (!index2) {
                parseError('Unmatched "');
              }
            } while (token[index2 - 2] === "\\");
            buffer += token.slice(i, index2);
            i = index2 - 1;
            switch (state) {
              case "before-value":
                state = "value";
                break;
              case "importRule-begin":
                state = "importRule";
                break;
            }
            break;
          case "'":
            index2 = i + 1;
            do {
              index2 = token.indexOf("'", index2) + 1;
              if (!index2) {
                parseError("Unmatched '");
              }
            } while (token[index2 - 2] === "\\");
            buffer += token.slice(i, index2);
            i = index2 - 1;
            switch (state) {
              case "before-value":
                state = "value";
                break;
              case "importRule-begin":
                state = "importRule";
                break;
            }
            break;
          // Comment
          case "/":
            if (token.charAt(i + 1) === "*") {
              i += 2;
              index2 = token.indexOf("*/", i);
              if (index2 === -1) {
                parseError("Missing */");
              } else {
                i = index2 + 1;
              }
            } else {
              buffer += character;
            }
            if (state === "importRule-begin") {
              buffer += " ";
              state = "importRule";
            }
            break;
          // At-rule
          case "@":
            if (token.indexOf("@-moz-document", i) === i) {
              state = "documentRule-begin";
              documentRule = new CSSOM.CSSDocumentRule();
              documentRule.__starts = i;
              i += "-moz-document".length;
              buffer = "";
              break;
            } else if (token.indexOf("@media", i) === i) {
              state = "atBlock";
              mediaRule = new CSSOM.CSSMediaRule();
              mediaRule.__starts = i;
              i += "media".length;
              buffer = "";
              break;
            } else if (token.indexOf("@supports", i) === i) {
              state = "conditionBlock";
              supportsRule = new CSSOM.CSSSupportsRule();
              supportsRule.__starts = i;
              i += "supports".length;
              buffer = "";
              break;
            } else if (token.indexOf("@host", i) === i) {
              state = "hostRule-begin";
              i += "host".length;
              hostRule = new CSSOM.CSSHostRule();
              hostRule.__starts = i;
              buffer = "";
              break;
            } else if (token.indexOf("@import", i) === i) {
              state = "importRule-begin";
              i += "import".length;
              buffer += "@import";
              break;
            } else if (token.indexOf("@font-face", i) === i) {
              state = "fontFaceRule-begin";
              i += "font-face".length;
              fontFaceRule = new CSSOM.CSSFontFaceRule();
              fontFaceRule.__starts = i;
              buffer = "";
              break;
            } else {
              atKeyframesRegExp.lastIndex = i;
              var matchKeyframes = atKeyframesRegExp.exec(token);
              if (matchKeyframes && matchKeyframes.index === i) {
                state = "keyframesRule-begin";
                keyframesRule = new CSSOM.CSSKeyframesRule();
                keyframesRule.__starts = i;
                keyframesRule._vendorPrefix = matchKeyframes[1];
                i += matchKeyframes[0].length - 1;
                buffer = "";
                break;
              } else if (state === "selector") {
                state = "atRule";
              }
            }
            buffer += character;
            break;
          case "{":
            if (state === "selector" || state === "atRule") {
              styleRule.selectorText = buffer.trim();
              styleRule.style.__starts = i;
              buffer = "";
              state = "before-name";
            } else if (state === "atBlock") {
              mediaRule.media.mediaText = buffer.trim();
              if (parentRule) {
                ancestorRules.push(parentRule);
              }
              currentScope = parentRule = mediaRule;
              mediaRule.parentStyleSheet = styleSheet;
              buffer = "";
              state = "before-selector";
            } else if (state === "conditionBlock") {
              supportsRule.conditionText = buffer.trim();
              if (parentRule) {
                ancestorRules.push(parentRule);
              }
              currentScope = parentRule = supportsRule;
              supportsRule.parentStyleSheet = styleSheet;
              buffer = "";
              state = "before-selector";
            } else if (state === "hostRule-begin") {
              if (parentRule) {
                ancestorRules.push(parentRule);
              }
              currentScope = parentRule = hostRule;
              hostRule.parentStyleSheet = styleSheet;
              buffer = "";
              state = "before-selector";
            } else if (state === "fontFaceRule-begin") {
              if (parentRule) {
                fontFaceRule.parentRule = parentRule;
              }
              fontFaceRule.parentStyleSheet = styleSheet;
              styleRule = fontFaceRule;
              buffer = "";
              state = "before-name";
            } else if (state === "keyframesRule-begin") {
              keyframesRule.name = buffer.trim();
              if (parentRule) {
                ancestorRules.push(parentRule);
                keyframesRule.parentRule = parentRule;
              }
              keyframesRule.parentStyleSheet = styleSheet;
              currentScope = parentRule = keyframesRule;
              buffer = "";
              state = "keyframeRule-begin";
            } else if (state === "keyframeRule-begin") {
              styleRule = new CSSOM.CSSKeyframeRule();
              styleRule.keyText = buffer.trim();
              styleRule.__starts = i;
              buffer = "";
              state = "before-name";
            } else if (state === "documentRule-begin") {
              documentRule.matcher.matcherText = buffer.trim();
              if (parentRule) {
                ancestorRules.push(parentRule);
                documentRule.parentRule = parentRule;
              }
              currentScope = parentRule = documentRule;
              documentRule.parentStyleSheet = styleSheet;
              buffer = "";
              state = "before-selector";
            }
            break;
          case ":":
            if (state === "name") {
              name = buffer.trim();
              buffer = "";
              state = "before-value";
            } else {
              buffer += character;
            }
            break;
          case "(":
            if (state === "value") {
              if (buffer.trim() === "expression") {
                var info = new CSSOM.CSSValueExpression(token, i).parse();
                if (info.error) {
                  parseError(info.error);
                } else {
                  buffer += info.expression;
                  i = info.idx;
                }
              } else {
                state = "value-parenthesis";
                valueParenthesisDepth = 1;
                buffer += character;
              }
            } else if (state === "value-parenthesis") {
              valueParenthesisDepth++;
              buffer += character;
            } else {
              buffer += character;
            }
            break;
          case ")":
            if (state === "value-parenthesis") {
              valueParenthesisDepth--;
              if (valueParenthesisDepth === 0) state = "value";
            }
            buffer += character;
            break;
          case "!":
            if (state === "value" && token.indexOf("!important", i) === i) {
              priority = "important";
              i += "important".length;
            } else {
              buffer += character;
            }
            break;
          case ";":
            switch (state) {
              case "value":
                styleRule.style.setProperty(name, buffer.trim(), priority);
                priority = "";
                buffer = "";
                state = "before-name";
                break;
              case "atRule":
                buffer = "";
                state = "before-selector";
                break;
              case "importRule":
                importRule = new CSSOM.CSSImportRule();
                importRule.parentStyleSheet = importRule.styleSheet.parentStyleSheet = styleSheet;
                importRule.cssText = buffer + character;
                styleSheet.cssRules.push(importRule);
                buffer = "";
                state = "before-selector";
                break;
              default:
                buffer += character;
                break;
            }
            break;
          case "}":
            switch (state) {
              case "value":
                styleRule.style.setProperty(name, buffer.trim(), priority);
                priority = "";
              /* falls through */
              case "before-name":
              case "name":
                styleRule.__ends = i + 1;
                if (parentRule) {
                  styleRule.parentRule = parentRule;
                }
                styleRule.parentStyleSheet = styleSheet;
                currentScope.cssRules.push(styleRule);
                buffer = "";
                if (currentScope.constructor === CSSOM.CSSKeyframesRule) {
                  state = "keyframeRule-begin";
                } else {
                  state = "before-selector";
                }
                break;
              case "keyframeRule-begin":
              case "before-selector":
              case "selector":
                if (!parentRule) {
                  parseError("Unexpected }");
                }
                hasAncestors = ancestorRules.length > 0;
                while (ancestorRules.length > 0) {
                  parentRule = ancestorRules.pop();
                  if (parentRule.constructor.name === "CSSMediaRule" || parentRule.constructor.name === "CSSSupportsRule") {
                    prevScope = currentScope;
                    currentScope = parentRule;
                    currentScope.cssRules.push(prevScope);
                    break;
                  }
                  if (ancestorRules.length === 0) {
                    hasAncestors = false;
                  }
                }
                if (!hasAncestors) {
                  currentScope.__ends = i + 1;
                  styleSheet.cssRules.push(currentScope);
                  currentScope = styleSheet;
                  parentRule = null;
                }
                buffer = "";
                state = "before-selector";
                break;
            }
            break;
          default:
            switch (state) {
              case "before-selector":
                state = "selector";
                styleRule = new CSSOM.CSSStyleRule();
                styleRule.__starts = i;
                break;
              case "before-name":
                state = "name";
                break;
              case "before-value":
                state = "value";
                break;
              case "importRule-begin":
                state = "importRule";
                break;
            }
            buffer += character;
            break;
        }
      }
      return styleSheet;
    };
    parse$1.parse = CSSOM.parse;
    CSSOM.CSSStyleSheet = requireCSSStyleSheet().CSSStyleSheet;
    CSSOM.CSSStyleRule = requireCSSStyleRule().CSSStyleRule;
    CSSOM.CSSImportRule = requireCSSImportRule().CSSImportRule;
    CSSOM.CSSGroupingRule = requireCSSGroupingRule().CSSGroupingRule;
    CSSOM.CSSMediaRule = requireCSSMediaRule().CSSMediaRule;
    CSSOM.CSSConditionRule = requireCSSConditionRule().CSSConditionRule;
    CSSOM.CSSSupportsRule = requireCSSSupportsRule().CSSSupportsRule;
    CSSOM.CSSFontFaceRule = requireCSSFontFaceRule().CSSFontFaceRule;
    CSSOM.CSSHostRule = requireCSSHostRule().CSSHostRule;
    CSSOM.CSSStyleDeclaration = requireCSSStyleDeclaration().CSSStyleDeclaration;
    CSSOM.CSSKeyframeRule = requireCSSKeyframeRule().CSSKeyframeRule;
    CSSOM.CSSKeyframesRule = requireCSSKeyframesRule().CSSKeyframesRule;
    CSSOM.CSSValueExpression = requireCSSValueExpression().CSSValueExpression;
    CSSOM.CSSDocumentRule = requireCSSDocumentRule().CSSDocumentRule;
    return parse$1;
  }
  var hasRequiredCSSStyleDeclaration;
  function requireCSSStyleDeclaration() {
    if (hasRequiredCSSStyleDeclaration) return CSSStyleDeclaration2;
    hasRequiredCSSStyleDeclaration = 1;
    var CSSOM = {};
    CSSOM.CSSStyleDeclaration = function CSSStyleDeclaration3() {
      this.length = 0;
      this.parentRule = null;
      this._importants = {};
    };
    CSSOM.CSSStyleDeclaration.prototype = {
      constructor: CSSOM.CSSStyleDeclaration,
      /**
       *
       * @param {string} name
       * @see http://www.w3.org/TR/DOM-Level-2-Style/css.html#CSS-CSSStyleDeclaration-getPropertyValue
       * @return {string} the value of the property if it has been explicitly set for this declaration block.
       * Returns the empty string if the property has not been set.
       */
      getPropertyValue: function(name) {
        return this[name] || "";
      },
      /**
       *
       * @param {string} name
       * @param {string} value
       * @param {string} [priority=null] "important" or null
       * @see http://www.w3.org/TR/DOM-Level-2-Style/css.html#CSS-CSSStyleDeclaration-setProperty
       */
      setProperty: function(name, value, priority) {
        if (this[name]) {
          var index2 = Array.prototype.indexOf.call(this, name);
          if (index2 < 0) {
            this[this.length] = name;
            this.length++;
          }
        } else {
          this[this.length] = name;
          this.length++;
        }
        this[name] = value + "";
        this._importants[name] = priority;
      },
      /**
       *
       * @param {string} name
       * @see http://www.w3.org/TR/DOM-Level-2-Style/css.html#CSS-CSSStyleDeclaration-removeProperty
       * @return {string} the value of the property if it has been explicitly set for this declaration block.
       * Returns the empty string if the property has not been set or the property name does not correspond to a known CSS property.
       */
      removeProperty: function(name) {
        if (!(name in this)) {
          return "";
        }
        var index2 = Array.prototype.indexOf.call(this, name);
        if (index2 < 0) {
          return "";
        }
        var prevValue = this[name];
        this[name] = "";
        Array.prototype.splice.call(this, index2, 1);
        return prevValue;
      },
      getPropertyCSSValue: function() {
      },
      /**
       *
       * @param {String} name
       */
      getPropertyPriority: function(name) {
        return this._importants[name] || "";
      },
      /**
       *   element.style.overflow = "auto"
       *   element.style.getPropertyShorthand("overflow-x")
       *   -> "overflow"
       */
      getPropertyShorthand: function() {
      },
      isPropertyImplicit: function() {
      },
      // Doesn't work in IE < 9
      get cssText() {
        var properties = [];
        for (var i = 0, length = this.length; i < length; ++i) {
          var name = this[i];
          var value = this.getPropertyValue(name);
          var priority = this.getPropertyPriority(name);
          if (priority) {
            priority = " !" + priority;
          }
          properties[i] = name + ": " + value + priority + ";";
        }
        return properties.join(" ");
      },
      set cssText(text3) {
        var i, name;
        for (i = this.length; i--; ) {
          name = this[i];
          this[name] = "";
        }
        Array.prototype.splice.call(this, 0, this.length);
        this._importants = {};
        var dummyRule = CSSOM.parse("#bogus{" + text3 + "}").cssRules[0].style;
        var length = dummyRule.length;
        for (i = 0; i < length; ++i) {
          name = dummyRule[i];
          this.setProperty(dummyRule[i], dummyRule.getPropertyValue(name), dummyRule.getPropertyPriority(name));
        }
      }
    };
    CSSStyleDeclaration2.CSSStyleDeclaration = CSSOM.CSSStyleDeclaration;
    CSSOM.parse = requireParse().parse;
    return CSSStyleDeclaration2;
  }
  var clone = {};
  var hasRequiredClone;
  function requireClone() {
    if (hasRequiredClone) return clone;
    hasRequiredClone = 1;
    var CSSOM = {
      CSSStyleSheet: requireCSSStyleSheet().CSSStyleSheet,
      CSSRule: requireCSSRule().CSSRule,
      CSSStyleRule: requireCSSStyleRule().CSSStyleRule,
      CSSGroupingRule: requireCSSGroupingRule().CSSGroupingRule,
      CSSConditionRule: requireCSSConditionRule().CSSConditionRule,
      CSSMediaRule: requireCSSMediaRule().CSSMediaRule,
      CSSSupportsRule: requireCSSSupportsRule().CSSSupportsRule,
      CSSStyleDeclaration: requireCSSStyleDeclaration().CSSStyleDeclaration,
      CSSKeyframeRule: requireCSSKeyframeRule().CSSKeyframeRule,
      CSSKeyframesRule: requireCSSKeyframesRule().CSSKeyframesRule
    };
    CSSOM.clone = function clone2(stylesheet) {
      var cloned = new CSSOM.CSSStyleSheet();
      var rules = stylesheet.cssRules;
      if (!rules) {
        return cloned;
      }
      for (var i = 0, rulesLength = rules.length; i < rulesLength; i++) {
        var rule = rules[i];
        var ruleClone = cloned.cssRules[i] = new rule.constructor();
        var style = rule.style;
        if (style) {
          var styleClone = ruleClone.style = new CSSOM.CSSStyleDeclaration();
          for (var j = 0, styleLength = style.length; j < styleLength; j++) {
            var name = styleClone[j] = style[j];
            styleClone[name] = style[name];
            styleClone._importants[name] = style.getPropertyPriority(name);
          }
          styleClone.length = style.length;
        }
        if (rule.hasOwnProperty("keyText")) {
          ruleClone.keyText = rule.keyText;
        }
        if (rule.hasOwnProperty("selectorText")) {
          ruleClone.selectorText = rule.selectorText;
        }
        if (rule.hasOwnProperty("mediaText")) {
          ruleClone.mediaText = rule.mediaText;
        }
        if (rule.hasOwnProperty("conditionText")) {
          ruleClone.conditionText = rule.conditionText;
        }
        if (rule.hasOwnProperty("cssRules")) {
          ruleClone.cssRules = clone2(rule).cssRules;
        }
      }
      return cloned;
    };
    clone.clone = CSSOM.clone;
    return clone;
  }
  var hasRequiredLib;
  function requireLib() {
    if (hasRequiredLib) return lib;
    hasRequiredLib = 1;
    lib.CSSStyleDeclaration = requireCSSStyleDeclaration().CSSStyleDeclaration;
    lib.CSSRule = requireCSSRule().CSSRule;
    lib.CSSGroupingRule = requireCSSGroupingRule().CSSGroupingRule;
    lib.CSSConditionRule = requireCSSConditionRule().CSSConditionRule;
    lib.CSSStyleRule = requireCSSStyleRule().CSSStyleRule;
    lib.MediaList = requireMediaList().MediaList;
    lib.CSSMediaRule = requireCSSMediaRule().CSSMediaRule;
    lib.CSSSupportsRule = requireCSSSupportsRule().CSSSupportsRule;
    lib.CSSImportRule = requireCSSImportRule().CSSImportRule;
    lib.CSSFontFaceRule = requireCSSFontFaceRule().CSSFontFaceRule;
    lib.CSSHostRule = requireCSSHostRule().CSSHostRule;
    lib.StyleSheet = requireStyleSheet().StyleSheet;
    lib.CSSStyleSheet = requireCSSStyleSheet().CSSStyleSheet;
    lib.CSSKeyframesRule = requireCSSKeyframesRule().CSSKeyframesRule;
    lib.CSSKeyframeRule = requireCSSKeyframeRule().CSSKeyframeRule;
    lib.MatcherList = requireMatcherList().MatcherList;
    lib.CSSDocumentRule = requireCSSDocumentRule().CSSDocumentRule;
    lib.CSSValue = requireCSSValue().CSSValue;
    lib.CSSValueExpression = requireCSSValueExpression().CSSValueExpression;
    lib.parse = requireParse().parse;
    lib.clone = requireClone().clone;
    return lib;
  }
  var libExports = requireLib();
  var tagName$e = "style";
  var HTMLStyleElement = class extends TextElement {
    constructor(ownerDocument, localName = tagName$e) {
      super(ownerDocument, localName);
      this[SHEET] = null;
    }
    get sheet() {
      const sheet = this[SHEET];
      if (sheet !== null) {
        return sheet;
      }
      return this[SHEET] = libExports.parse(this.textContent);
    }
    get innerHTML() {
      return super.innerHTML || "";
    }
    set innerHTML(value) {
      super.textContent = value;
      this[SHEET] = null;
    }
    get innerText() {
      return super.innerText || "";
    }
    set innerText(value) {
      super.textContent = value;
      this[SHEET] = null;
    }
    get textContent() {
      return super.textContent || "";
    }
    set textContent(value) {
      super.textContent = value;
      this[SHEET] = null;
    }
  };
  registerHTMLClass(tagName$e, HTMLStyleElement);
  var HTMLTimeElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "time") {
      super(ownerDocument, localName);
    }
    /**
     * @type {string}
     */
    get dateTime() {
      return stringAttribute.get(this, "datetime");
    }
    set dateTime(value) {
      stringAttribute.set(this, "datetime", value);
    }
  };
  registerHTMLClass("time", HTMLTimeElement);
  var HTMLFieldSetElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "fieldset") {
      super(ownerDocument, localName);
    }
  };
  var HTMLEmbedElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "embed") {
      super(ownerDocument, localName);
    }
  };
  var HTMLHRElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "hr") {
      super(ownerDocument, localName);
    }
  };
  var HTMLProgressElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "progress") {
      super(ownerDocument, localName);
    }
  };
  var HTMLParagraphElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "p") {
      super(ownerDocument, localName);
    }
  };
  var HTMLTableElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "table") {
      super(ownerDocument, localName);
    }
  };
  var HTMLFrameSetElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "frameset") {
      super(ownerDocument, localName);
    }
  };
  var HTMLLIElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "li") {
      super(ownerDocument, localName);
    }
  };
  var HTMLBaseElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "base") {
      super(ownerDocument, localName);
    }
  };
  var HTMLDataListElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "datalist") {
      super(ownerDocument, localName);
    }
  };
  var tagName$d = "input";
  var HTMLInputElement = class extends HTMLElement {
    constructor(ownerDocument, localName = tagName$d) {
      super(ownerDocument, localName);
    }
    /* c8 ignore start */
    get autofocus() {
      return booleanAttribute.get(this, "autofocus") || -1;
    }
    set autofocus(value) {
      booleanAttribute.set(this, "autofocus", value);
    }
    get disabled() {
      return booleanAttribute.get(this, "disabled");
    }
    set disabled(value) {
      booleanAttribute.set(this, "disabled", value);
    }
    get name() {
      return this.getAttribute("name");
    }
    set name(value) {
      this.setAttribute("name", value);
    }
    get placeholder() {
      return this.getAttribute("placeholder");
    }
    set placeholder(value) {
      this.setAttribute("placeholder", value);
    }
    get type() {
      return this.getAttribute("type");
    }
    set type(value) {
      this.setAttribute("type", value);
    }
    get value() {
      return stringAttribute.get(this, "value");
    }
    set value(value) {
      stringAttribute.set(this, "value", value);
    }
    /* c8 ignore stop */
  };
  registerHTMLClass(tagName$d, HTMLInputElement);
  var HTMLParamElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "param") {
      super(ownerDocument, localName);
    }
  };
  var HTMLMediaElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "media") {
      super(ownerDocument, localName);
    }
  };
  var HTMLAudioElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "audio") {
      super(ownerDocument, localName);
    }
  };
  var tagName$c = "h1";
  var HTMLHeadingElement = class extends HTMLElement {
    constructor(ownerDocument, localName = tagName$c) {
      super(ownerDocument, localName);
    }
  };
  registerHTMLClass([tagName$c, "h2", "h3", "h4", "h5", "h6"], HTMLHeadingElement);
  var HTMLDirectoryElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "dir") {
      super(ownerDocument, localName);
    }
  };
  var HTMLQuoteElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "quote") {
      super(ownerDocument, localName);
    }
  };
  var Canvas = class {
    constructor(width, height) {
      this.width = width;
      this.height = height;
    }
    getContext() {
      return null;
    }
    toDataURL() {
      return "";
    }
  };
  var Canvas$1 = { createCanvas: (width, height) => new Canvas(width, height) };
  var { createCanvas } = Canvas$1;
  var tagName$b = "canvas";
  var HTMLCanvasElement = class extends HTMLElement {
    constructor(ownerDocument, localName = tagName$b) {
      super(ownerDocument, localName);
      this[IMAGE] = createCanvas(300, 150);
    }
    get width() {
      return this[IMAGE].width;
    }
    set width(value) {
      numericAttribute.set(this, "width", value);
      this[IMAGE].width = value;
    }
    get height() {
      return this[IMAGE].height;
    }
    set height(value) {
      numericAttribute.set(this, "height", value);
      this[IMAGE].height = value;
    }
    getContext(type) {
      return this[IMAGE].getContext(type);
    }
    toDataURL(...args) {
      return this[IMAGE].toDataURL(...args);
    }
  };
  registerHTMLClass(tagName$b, HTMLCanvasElement);
  var HTMLLegendElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "legend") {
      super(ownerDocument, localName);
    }
  };
  var tagName$a = "option";
  var HTMLOptionElement = class extends HTMLElement {
    constructor(ownerDocument, localName = tagName$a) {
      super(ownerDocument, localName);
    }
    /* c8 ignore start */
    get value() {
      return stringAttribute.get(this, "value");
    }
    set value(value) {
      stringAttribute.set(this, "value", value);
    }
    /* c8 ignore stop */
    get selected() {
      return booleanAttribute.get(this, "selected");
    }
    set selected(value) {
      const option = this.parentElement?.querySelector("option[selected]");
      if (option && option !== this)
        option.selected = false;
      booleanAttribute.set(this, "selected", value);
    }
  };
  registerHTMLClass(tagName$a, HTMLOptionElement);
  var HTMLSpanElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "span") {
      super(ownerDocument, localName);
    }
  };
  var HTMLMeterElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "meter") {
      super(ownerDocument, localName);
    }
  };
  var HTMLVideoElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "video") {
      super(ownerDocument, localName);
    }
  };
  var HTMLTableCellElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "td") {
      super(ownerDocument, localName);
    }
  };
  var tagName$9 = "title";
  var HTMLTitleElement = class extends TextElement {
    constructor(ownerDocument, localName = tagName$9) {
      super(ownerDocument, localName);
    }
  };
  registerHTMLClass(tagName$9, HTMLTitleElement);
  var HTMLOutputElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "output") {
      super(ownerDocument, localName);
    }
  };
  var HTMLTableRowElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "tr") {
      super(ownerDocument, localName);
    }
  };
  var HTMLDataElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "data") {
      super(ownerDocument, localName);
    }
  };
  var HTMLMenuElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "menu") {
      super(ownerDocument, localName);
    }
  };
  var tagName$8 = "select";
  var HTMLSelectElement = class extends HTMLElement {
    constructor(ownerDocument, localName = tagName$8) {
      super(ownerDocument, localName);
    }
    get options() {
      let children = new NodeList();
      let { firstElementChild } = this;
      while (firstElementChild) {
        if (firstElementChild.tagName === "OPTGROUP")
          children.push(...firstElementChild.children);
        else
          children.push(firstElementChild);
        firstElementChild = firstElementChild.nextElementSibling;
      }
      return children;
    }
    /* c8 ignore start */
    get disabled() {
      return booleanAttribute.get(this, "disabled");
    }
    set disabled(value) {
      booleanAttribute.set(this, "disabled", value);
    }
    get name() {
      return this.getAttribute("name");
    }
    set name(value) {
      this.setAttribute("name", value);
    }
    /* c8 ignore stop */
    get value() {
      return this.querySelector("option[selected]")?.value;
    }
  };
  registerHTMLClass(tagName$8, HTMLSelectElement);
  var HTMLBRElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "br") {
      super(ownerDocument, localName);
    }
  };
  var tagName$7 = "button";
  var HTMLButtonElement = class extends HTMLElement {
    constructor(ownerDocument, localName = tagName$7) {
      super(ownerDocument, localName);
    }
    /* c8 ignore start */
    get disabled() {
      return booleanAttribute.get(this, "disabled");
    }
    set disabled(value) {
      booleanAttribute.set(this, "disabled", value);
    }
    get name() {
      return this.getAttribute("name");
    }
    set name(value) {
      this.setAttribute("name", value);
    }
    get type() {
      return this.getAttribute("type");
    }
    set type(value) {
      this.setAttribute("type", value);
    }
    /* c8 ignore stop */
  };
  registerHTMLClass(tagName$7, HTMLButtonElement);
  var HTMLMapElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "map") {
      super(ownerDocument, localName);
    }
  };
  var HTMLOptGroupElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "optgroup") {
      super(ownerDocument, localName);
    }
  };
  var HTMLDListElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "dl") {
      super(ownerDocument, localName);
    }
  };
  var tagName$6 = "textarea";
  var HTMLTextAreaElement = class extends TextElement {
    constructor(ownerDocument, localName = tagName$6) {
      super(ownerDocument, localName);
    }
    /* c8 ignore start */
    get disabled() {
      return booleanAttribute.get(this, "disabled");
    }
    set disabled(value) {
      booleanAttribute.set(this, "disabled", value);
    }
    get name() {
      return this.getAttribute("name");
    }
    set name(value) {
      this.setAttribute("name", value);
    }
    get placeholder() {
      return this.getAttribute("placeholder");
    }
    set placeholder(value) {
      this.setAttribute("placeholder", value);
    }
    get type() {
      return this.getAttribute("type");
    }
    set type(value) {
      this.setAttribute("type", value);
    }
    get value() {
      return this.textContent;
    }
    set value(content) {
      this.textContent = content;
    }
    /* c8 ignore stop */
  };
  registerHTMLClass(tagName$6, HTMLTextAreaElement);
  var HTMLFontElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "font") {
      super(ownerDocument, localName);
    }
  };
  var HTMLDivElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "div") {
      super(ownerDocument, localName);
    }
  };
  var tagName$5 = "link";
  var HTMLLinkElement = class extends HTMLElement {
    constructor(ownerDocument, localName = tagName$5) {
      super(ownerDocument, localName);
    }
    /* c8 ignore start */
    // copy paste from img.src, already covered
    get disabled() {
      return booleanAttribute.get(this, "disabled");
    }
    set disabled(value) {
      booleanAttribute.set(this, "disabled", value);
    }
    get href() {
      return stringAttribute.get(this, "href").trim();
    }
    set href(value) {
      stringAttribute.set(this, "href", value);
    }
    get hreflang() {
      return stringAttribute.get(this, "hreflang");
    }
    set hreflang(value) {
      stringAttribute.set(this, "hreflang", value);
    }
    get media() {
      return stringAttribute.get(this, "media");
    }
    set media(value) {
      stringAttribute.set(this, "media", value);
    }
    get rel() {
      return stringAttribute.get(this, "rel");
    }
    set rel(value) {
      stringAttribute.set(this, "rel", value);
    }
    get type() {
      return stringAttribute.get(this, "type");
    }
    set type(value) {
      stringAttribute.set(this, "type", value);
    }
    /* c8 ignore stop */
  };
  registerHTMLClass(tagName$5, HTMLLinkElement);
  var tagName$4 = "slot";
  var HTMLSlotElement = class extends HTMLElement {
    constructor(ownerDocument, localName = tagName$4) {
      super(ownerDocument, localName);
    }
    /* c8 ignore start */
    get name() {
      return this.getAttribute("name");
    }
    set name(value) {
      this.setAttribute("name", value);
    }
    assign() {
    }
    assignedNodes(options) {
      const isNamedSlot = !!this.name;
      const hostChildNodes = this.getRootNode().host?.childNodes ?? [];
      let slottables;
      if (isNamedSlot) {
        slottables = [...hostChildNodes].filter((node) => node.slot === this.name);
      } else {
        slottables = [...hostChildNodes].filter((node) => !node.slot);
      }
      if (options?.flatten) {
        const result = [];
        for (let slottable of slottables) {
          if (slottable.localName === "slot") {
            result.push(...slottable.assignedNodes({ flatten: true }));
          } else {
            result.push(slottable);
          }
        }
        slottables = result;
      }
      return slottables.length ? slottables : [...this.childNodes];
    }
    assignedElements(options) {
      const slottables = this.assignedNodes(options).filter((n) => n.nodeType === 1);
      return slottables.length ? slottables : [...this.children];
    }
    /* c8 ignore stop */
  };
  registerHTMLClass(tagName$4, HTMLSlotElement);
  var HTMLFormElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "form") {
      super(ownerDocument, localName);
    }
  };
  var tagName$3 = "img";
  var HTMLImageElement = class extends HTMLElement {
    constructor(ownerDocument, localName = tagName$3) {
      super(ownerDocument, localName);
    }
    /* c8 ignore start */
    get alt() {
      return stringAttribute.get(this, "alt");
    }
    set alt(value) {
      stringAttribute.set(this, "alt", value);
    }
    get sizes() {
      return stringAttribute.get(this, "sizes");
    }
    set sizes(value) {
      stringAttribute.set(this, "sizes", value);
    }
    get src() {
      return stringAttribute.get(this, "src");
    }
    set src(value) {
      stringAttribute.set(this, "src", value);
    }
    get srcset() {
      return stringAttribute.get(this, "srcset");
    }
    set srcset(value) {
      stringAttribute.set(this, "srcset", value);
    }
    get title() {
      return stringAttribute.get(this, "title");
    }
    set title(value) {
      stringAttribute.set(this, "title", value);
    }
    get width() {
      return numericAttribute.get(this, "width");
    }
    set width(value) {
      numericAttribute.set(this, "width", value);
    }
    get height() {
      return numericAttribute.get(this, "height");
    }
    set height(value) {
      numericAttribute.set(this, "height", value);
    }
    /* c8 ignore stop */
  };
  registerHTMLClass(tagName$3, HTMLImageElement);
  var HTMLPreElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "pre") {
      super(ownerDocument, localName);
    }
  };
  var HTMLUListElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "ul") {
      super(ownerDocument, localName);
    }
  };
  var tagName$2 = "meta";
  var HTMLMetaElement = class extends HTMLElement {
    constructor(ownerDocument, localName = tagName$2) {
      super(ownerDocument, localName);
    }
    /* c8 ignore start */
    get name() {
      return stringAttribute.get(this, "name");
    }
    set name(value) {
      stringAttribute.set(this, "name", value);
    }
    get httpEquiv() {
      return stringAttribute.get(this, "http-equiv");
    }
    set httpEquiv(value) {
      stringAttribute.set(this, "http-equiv", value);
    }
    get content() {
      return stringAttribute.get(this, "content");
    }
    set content(value) {
      stringAttribute.set(this, "content", value);
    }
    get charset() {
      return stringAttribute.get(this, "charset");
    }
    set charset(value) {
      stringAttribute.set(this, "charset", value);
    }
    get media() {
      return stringAttribute.get(this, "media");
    }
    set media(value) {
      stringAttribute.set(this, "media", value);
    }
    /* c8 ignore stop */
  };
  registerHTMLClass(tagName$2, HTMLMetaElement);
  var HTMLPictureElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "picture") {
      super(ownerDocument, localName);
    }
  };
  var HTMLAreaElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "area") {
      super(ownerDocument, localName);
    }
  };
  var HTMLOListElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "ol") {
      super(ownerDocument, localName);
    }
  };
  var HTMLTableCaptionElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "caption") {
      super(ownerDocument, localName);
    }
  };
  var tagName$1 = "a";
  var HTMLAnchorElement = class extends HTMLElement {
    constructor(ownerDocument, localName = tagName$1) {
      super(ownerDocument, localName);
    }
    /* c8 ignore start */
    // copy paste from img.src, already covered
    get href() {
      return encodeURI(decodeURI(stringAttribute.get(this, "href"))).trim();
    }
    set href(value) {
      stringAttribute.set(this, "href", decodeURI(value));
    }
    get download() {
      return encodeURI(decodeURI(stringAttribute.get(this, "download")));
    }
    set download(value) {
      stringAttribute.set(this, "download", decodeURI(value));
    }
    get target() {
      return stringAttribute.get(this, "target");
    }
    set target(value) {
      stringAttribute.set(this, "target", value);
    }
    get type() {
      return stringAttribute.get(this, "type");
    }
    set type(value) {
      stringAttribute.set(this, "type", value);
    }
    get rel() {
      return stringAttribute.get(this, "rel");
    }
    set rel(value) {
      stringAttribute.set(this, "rel", value);
    }
    /* c8 ignore stop */
  };
  registerHTMLClass(tagName$1, HTMLAnchorElement);
  var HTMLLabelElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "label") {
      super(ownerDocument, localName);
    }
  };
  var HTMLUnknownElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "unknown") {
      super(ownerDocument, localName);
    }
  };
  var HTMLModElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "mod") {
      super(ownerDocument, localName);
    }
  };
  var HTMLDetailsElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "details") {
      super(ownerDocument, localName);
    }
  };
  var tagName = "source";
  var HTMLSourceElement = class extends HTMLElement {
    constructor(ownerDocument, localName = tagName) {
      super(ownerDocument, localName);
    }
    /* c8 ignore start */
    get src() {
      return stringAttribute.get(this, "src");
    }
    set src(value) {
      stringAttribute.set(this, "src", value);
    }
    get srcset() {
      return stringAttribute.get(this, "srcset");
    }
    set srcset(value) {
      stringAttribute.set(this, "srcset", value);
    }
    get sizes() {
      return stringAttribute.get(this, "sizes");
    }
    set sizes(value) {
      stringAttribute.set(this, "sizes", value);
    }
    get type() {
      return stringAttribute.get(this, "type");
    }
    set type(value) {
      stringAttribute.set(this, "type", value);
    }
    /* c8 ignore stop */
  };
  registerHTMLClass(tagName, HTMLSourceElement);
  var HTMLTrackElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "track") {
      super(ownerDocument, localName);
    }
  };
  var HTMLMarqueeElement = class extends HTMLElement {
    constructor(ownerDocument, localName = "marquee") {
      super(ownerDocument, localName);
    }
  };
  var HTMLClasses = {
    HTMLElement,
    HTMLTemplateElement,
    HTMLHtmlElement,
    HTMLScriptElement,
    HTMLFrameElement,
    HTMLIFrameElement,
    HTMLObjectElement,
    HTMLHeadElement,
    HTMLBodyElement,
    HTMLStyleElement,
    HTMLTimeElement,
    HTMLFieldSetElement,
    HTMLEmbedElement,
    HTMLHRElement,
    HTMLProgressElement,
    HTMLParagraphElement,
    HTMLTableElement,
    HTMLFrameSetElement,
    HTMLLIElement,
    HTMLBaseElement,
    HTMLDataListElement,
    HTMLInputElement,
    HTMLParamElement,
    HTMLMediaElement,
    HTMLAudioElement,
    HTMLHeadingElement,
    HTMLDirectoryElement,
    HTMLQuoteElement,
    HTMLCanvasElement,
    HTMLLegendElement,
    HTMLOptionElement,
    HTMLSpanElement,
    HTMLMeterElement,
    HTMLVideoElement,
    HTMLTableCellElement,
    HTMLTitleElement,
    HTMLOutputElement,
    HTMLTableRowElement,
    HTMLDataElement,
    HTMLMenuElement,
    HTMLSelectElement,
    HTMLBRElement,
    HTMLButtonElement,
    HTMLMapElement,
    HTMLOptGroupElement,
    HTMLDListElement,
    HTMLTextAreaElement,
    HTMLFontElement,
    HTMLDivElement,
    HTMLLinkElement,
    HTMLSlotElement,
    HTMLFormElement,
    HTMLImageElement,
    HTMLPreElement,
    HTMLUListElement,
    HTMLMetaElement,
    HTMLPictureElement,
    HTMLAreaElement,
    HTMLOListElement,
    HTMLTableCaptionElement,
    HTMLAnchorElement,
    HTMLLabelElement,
    HTMLUnknownElement,
    HTMLModElement,
    HTMLDetailsElement,
    HTMLSourceElement,
    HTMLTrackElement,
    HTMLMarqueeElement
  };
  var voidElements = { test: () => true };
  var Mime = {
    "text/html": {
      docType: "<!DOCTYPE html>",
      ignoreCase: true,
      voidElements: /^(?:area|base|br|col|embed|hr|img|input|keygen|link|menuitem|meta|param|source|track|wbr)$/i
    },
    "image/svg+xml": {
      docType: '<?xml version="1.0" encoding="utf-8"?>',
      ignoreCase: false,
      voidElements
    },
    "text/xml": {
      docType: '<?xml version="1.0" encoding="utf-8"?>',
      ignoreCase: false,
      voidElements
    },
    "application/xml": {
      docType: '<?xml version="1.0" encoding="utf-8"?>',
      ignoreCase: false,
      voidElements
    },
    "application/xhtml+xml": {
      docType: '<?xml version="1.0" encoding="utf-8"?>',
      ignoreCase: false,
      voidElements
    }
  };
  var CustomEvent2 = class extends GlobalEvent {
    constructor(type, eventInitDict = {}) {
      super(type, eventInitDict);
      this.detail = eventInitDict.detail;
    }
  };
  var InputEvent = class extends GlobalEvent {
    constructor(type, inputEventInit = {}) {
      super(type, inputEventInit);
      this.inputType = inputEventInit.inputType;
      this.data = inputEventInit.data;
      this.dataTransfer = inputEventInit.dataTransfer;
      this.isComposing = inputEventInit.isComposing || false;
      this.ranges = inputEventInit.ranges;
    }
  };
  var ImageClass = (ownerDocument) => (
    /**
     * @implements globalThis.Image
     */
    class Image extends HTMLImageElement {
      constructor(width, height) {
        super(ownerDocument);
        switch (arguments.length) {
          case 1:
            this.height = width;
            this.width = width;
            break;
          case 2:
            this.height = height;
            this.width = width;
            break;
        }
      }
    }
  );
  var deleteContents = ({ [START]: start, [END]: end2 }, fragment = null) => {
    setAdjacent(start[PREV], end2[NEXT]);
    do {
      const after2 = getEnd(start);
      const next = after2 === end2 ? after2 : after2[NEXT];
      if (fragment)
        fragment.insertBefore(start, fragment[END]);
      else
        start.remove();
      start = next;
    } while (start !== end2);
  };
  var Range = class _Range {
    constructor() {
      this[START] = null;
      this[END] = null;
      this.commonAncestorContainer = null;
    }
    /* TODO: this is more complicated than it looks
      setStart(node, offset) {
        this[START] = node.childNodes[offset];
      }
    
      setEnd(node, offset) {
        this[END] = getEnd(node.childNodes[offset]);
      }
      //*/
    insertNode(newNode) {
      this[END].parentNode.insertBefore(newNode, this[START]);
    }
    selectNode(node) {
      this[START] = node;
      this[END] = getEnd(node);
    }
    // TODO: SVG elements should then create contextual fragments
    //       that return SVG nodes
    selectNodeContents(node) {
      this.selectNode(node);
      this.commonAncestorContainer = node;
    }
    surroundContents(parentNode) {
      parentNode.replaceChildren(this.extractContents());
    }
    setStartBefore(node) {
      this[START] = node;
    }
    setStartAfter(node) {
      this[START] = node.nextSibling;
    }
    setEndBefore(node) {
      this[END] = getEnd(node.previousSibling);
    }
    setEndAfter(node) {
      this[END] = getEnd(node);
    }
    cloneContents() {
      let { [START]: start, [END]: end2 } = this;
      const fragment = start.ownerDocument.createDocumentFragment();
      while (start !== end2) {
        fragment.insertBefore(start.cloneNode(true), fragment[END]);
        start = getEnd(start);
        if (start !== end2)
          start = start[NEXT];
      }
      return fragment;
    }
    deleteContents() {
      deleteContents(this);
    }
    extractContents() {
      const fragment = this[START].ownerDocument.createDocumentFragment();
      deleteContents(this, fragment);
      return fragment;
    }
    createContextualFragment(html3) {
      const { commonAncestorContainer: doc } = this;
      const isSVG = "ownerSVGElement" in doc;
      const document3 = isSVG ? doc.ownerDocument : doc;
      let content = htmlToFragment(document3, html3);
      if (isSVG) {
        const childNodes = [...content.childNodes];
        content = document3.createDocumentFragment();
        Object.setPrototypeOf(content, SVGElement$1.prototype);
        content.ownerSVGElement = document3;
        for (const child of childNodes) {
          Object.setPrototypeOf(child, SVGElement$1.prototype);
          child.ownerSVGElement = document3;
          content.appendChild(child);
        }
      } else
        this.selectNode(content);
      return content;
    }
    cloneRange() {
      const range = new _Range();
      range[START] = this[START];
      range[END] = this[END];
      return range;
    }
  };
  var isOK = ({ nodeType }, mask) => {
    switch (nodeType) {
      case ELEMENT_NODE:
        return mask & SHOW_ELEMENT;
      case TEXT_NODE:
        return mask & SHOW_TEXT;
      case COMMENT_NODE:
        return mask & SHOW_COMMENT;
      case CDATA_SECTION_NODE:
        return mask & SHOW_CDATA_SECTION;
    }
    return 0;
  };
  var TreeWalker = class {
    constructor(root, whatToShow = SHOW_ALL) {
      this.root = root;
      this.currentNode = root;
      this.whatToShow = whatToShow;
      let { [NEXT]: next, [END]: end2 } = root;
      if (root.nodeType === DOCUMENT_NODE) {
        const { documentElement } = root;
        next = documentElement;
        end2 = documentElement[END];
      }
      const nodes = [];
      while (next && next !== end2) {
        if (isOK(next, whatToShow))
          nodes.push(next);
        next = next[NEXT];
      }
      this[PRIVATE] = { i: 0, nodes };
    }
    nextNode() {
      const $ = this[PRIVATE];
      this.currentNode = $.i < $.nodes.length ? $.nodes[$.i++] : null;
      return this.currentNode;
    }
  };
  var query = (method, ownerDocument, selectors) => {
    let { [NEXT]: next, [END]: end2 } = ownerDocument;
    return method.call({ ownerDocument, [NEXT]: next, [END]: end2 }, selectors);
  };
  var globalExports = assign(
    {},
    Facades,
    HTMLClasses,
    {
      CustomEvent: CustomEvent2,
      Event: GlobalEvent,
      EventTarget: DOMEventTarget,
      InputEvent,
      NamedNodeMap,
      NodeList
    }
  );
  var window = /* @__PURE__ */ new WeakMap();
  var Document$1 = class Document2 extends NonElementParentNode {
    constructor(type) {
      super(null, "#document", DOCUMENT_NODE);
      this[CUSTOM_ELEMENTS] = { active: false, registry: null };
      this[MUTATION_OBSERVER] = { active: false, class: null };
      this[MIME] = Mime[type];
      this[DOCTYPE] = null;
      this[DOM_PARSER] = null;
      this[GLOBALS] = null;
      this[IMAGE] = null;
      this[UPGRADE] = null;
    }
    /**
     * @type {globalThis.Document['defaultView']}
     */
    get defaultView() {
      if (!window.has(this))
        window.set(this, new Proxy(globalThis, {
          set: (target, name, value) => {
            switch (name) {
              case "addEventListener":
              case "removeEventListener":
              case "dispatchEvent":
                this[EVENT_TARGET][name] = value;
                break;
              default:
                target[name] = value;
                break;
            }
            return true;
          },
          get: (globalThis2, name) => {
            switch (name) {
              case "addEventListener":
              case "removeEventListener":
              case "dispatchEvent":
                if (!this[EVENT_TARGET]) {
                  const et = this[EVENT_TARGET] = new DOMEventTarget();
                  et.dispatchEvent = et.dispatchEvent.bind(et);
                  et.addEventListener = et.addEventListener.bind(et);
                  et.removeEventListener = et.removeEventListener.bind(et);
                }
                return this[EVENT_TARGET][name];
              case "document":
                return this;
              /* c8 ignore start */
              case "navigator":
                return {
                  userAgent: "Mozilla/5.0 (X11; Linux x86_64) AppleWebKit/537.36 (KHTML, like Gecko) Chrome/88.0.4324.150 Safari/537.36"
                };
              /* c8 ignore stop */
              case "window":
                return window.get(this);
              case "customElements":
                if (!this[CUSTOM_ELEMENTS].registry)
                  this[CUSTOM_ELEMENTS] = new CustomElementRegistry(this);
                return this[CUSTOM_ELEMENTS];
              case "performance":
                return globalThis2.performance;
              case "DOMParser":
                return this[DOM_PARSER];
              case "Image":
                if (!this[IMAGE])
                  this[IMAGE] = ImageClass(this);
                return this[IMAGE];
              case "MutationObserver":
                if (!this[MUTATION_OBSERVER].class)
                  this[MUTATION_OBSERVER] = new MutationObserverClass(this);
                return this[MUTATION_OBSERVER].class;
            }
            return this[GLOBALS] && this[GLOBALS][name] || globalExports[name] || globalThis2[name];
          }
        }));
      return window.get(this);
    }
    get doctype() {
      const docType = this[DOCTYPE];
      if (docType)
        return docType;
      const { firstChild } = this;
      if (firstChild && firstChild.nodeType === DOCUMENT_TYPE_NODE)
        return this[DOCTYPE] = firstChild;
      return null;
    }
    set doctype(value) {
      if (/^([a-z:]+)(\s+system|\s+public(\s+"([^"]+)")?)?(\s+"([^"]+)")?/i.test(value)) {
        const { $1: name, $4: publicId, $6: systemId } = RegExp;
        this[DOCTYPE] = new DocumentType$1(this, name, publicId, systemId);
        knownSiblings(this, this[DOCTYPE], this[NEXT]);
      }
    }
    get documentElement() {
      return this.firstElementChild;
    }
    get isConnected() {
      return true;
    }
    /**
     * @protected
     */
    _getParent() {
      return this[EVENT_TARGET];
    }
    createAttribute(name) {
      return new Attr$1(this, name);
    }
    createCDATASection(data) {
      return new CDATASection$1(this, data);
    }
    createComment(textContent2) {
      return new Comment$1(this, textContent2);
    }
    createDocumentFragment() {
      return new DocumentFragment$1(this);
    }
    createDocumentType(name, publicId, systemId) {
      return new DocumentType$1(this, name, publicId, systemId);
    }
    createElement(localName) {
      return new Element$1(this, localName);
    }
    createRange() {
      const range = new Range();
      range.commonAncestorContainer = this;
      return range;
    }
    createTextNode(textContent2) {
      return new Text$1(this, textContent2);
    }
    createTreeWalker(root, whatToShow = -1) {
      return new TreeWalker(root, whatToShow);
    }
    createNodeIterator(root, whatToShow = -1) {
      return this.createTreeWalker(root, whatToShow);
    }
    createEvent(name) {
      const event = create$1(name === "Event" ? new GlobalEvent("") : new CustomEvent2(""));
      event.initEvent = event.initCustomEvent = (type, canBubble = false, cancelable = false, detail) => {
        event.bubbles = !!canBubble;
        defineProperties(event, {
          type: { value: type },
          canBubble: { value: canBubble },
          cancelable: { value: cancelable },
          detail: { value: detail }
        });
      };
      return event;
    }
    cloneNode(deep = false) {
      const {
        constructor,
        [CUSTOM_ELEMENTS]: customElements2,
        [DOCTYPE]: doctype
      } = this;
      const document3 = new constructor();
      document3[CUSTOM_ELEMENTS] = customElements2;
      if (deep) {
        const end2 = document3[END];
        const { childNodes } = this;
        for (let { length } = childNodes, i = 0; i < length; i++)
          document3.insertBefore(childNodes[i].cloneNode(true), end2);
        if (doctype)
          document3[DOCTYPE] = childNodes[0];
      }
      return document3;
    }
    importNode(externalNode) {
      const deep = 1 < arguments.length && !!arguments[1];
      const node = externalNode.cloneNode(deep);
      const { [CUSTOM_ELEMENTS]: customElements2 } = this;
      const { active } = customElements2;
      const upgrade = (element) => {
        const { ownerDocument, nodeType } = element;
        element.ownerDocument = this;
        if (active && ownerDocument !== this && nodeType === ELEMENT_NODE)
          customElements2.upgrade(element);
      };
      upgrade(node);
      if (deep) {
        switch (node.nodeType) {
          case ELEMENT_NODE:
          case DOCUMENT_FRAGMENT_NODE: {
            let { [NEXT]: next, [END]: end2 } = node;
            while (next !== end2) {
              if (next.nodeType === ELEMENT_NODE)
                upgrade(next);
              next = next[NEXT];
            }
            break;
          }
        }
      }
      return node;
    }
    toString() {
      return this.childNodes.join("");
    }
    querySelector(selectors) {
      return query(super.querySelector, this, selectors);
    }
    querySelectorAll(selectors) {
      return query(super.querySelectorAll, this, selectors);
    }
    /* c8 ignore start */
    getElementsByTagNameNS(_, name) {
      return this.getElementsByTagName(name);
    }
    createAttributeNS(_, name) {
      return this.createAttribute(name);
    }
    createElementNS(nsp, localName, options) {
      return nsp === SVG_NAMESPACE ? new SVGElement$1(this, localName, null) : this.createElement(localName, options);
    }
    /* c8 ignore stop */
  };
  setPrototypeOf(
    globalExports.Document = function Document3() {
      illegalConstructor();
    },
    Document$1
  ).prototype = Document$1.prototype;
  var createHTMLElement$1 = (ownerDocument, builtin, localName, options) => {
    if (!builtin && htmlClasses.has(localName)) {
      const Class = htmlClasses.get(localName);
      return new Class(ownerDocument, localName);
    }
    const { [CUSTOM_ELEMENTS]: { active, registry } } = ownerDocument;
    if (active) {
      const ce = builtin ? options.is : localName;
      if (registry.has(ce)) {
        const { Class } = registry.get(ce);
        const element = new Class(ownerDocument, localName);
        customElements.set(element, { connected: false });
        return element;
      }
    }
    return new HTMLElement(ownerDocument, localName);
  };
  var HTMLDocument = class extends Document$1 {
    constructor() {
      super("text/html");
    }
    get all() {
      const nodeList = new NodeList();
      let { [NEXT]: next, [END]: end2 } = this;
      while (next !== end2) {
        switch (next.nodeType) {
          case ELEMENT_NODE:
            nodeList.push(next);
            break;
        }
        next = next[NEXT];
      }
      return nodeList;
    }
    /**
     * @type HTMLHeadElement
     */
    get head() {
      const { documentElement } = this;
      let { firstElementChild } = documentElement;
      if (!firstElementChild || firstElementChild.tagName !== "HEAD") {
        firstElementChild = this.createElement("head");
        documentElement.prepend(firstElementChild);
      }
      return firstElementChild;
    }
    /**
     * @type HTMLBodyElement
     */
    get body() {
      const { head } = this;
      let { nextElementSibling: nextElementSibling2 } = head;
      if (!nextElementSibling2 || nextElementSibling2.tagName !== "BODY") {
        nextElementSibling2 = this.createElement("body");
        head.after(nextElementSibling2);
      }
      return nextElementSibling2;
    }
    /**
     * @type HTMLTitleElement
     */
    get title() {
      const { head } = this;
      return head.getElementsByTagName("title").at(0)?.textContent || "";
    }
    set title(textContent2) {
      const { head } = this;
      let title = head.getElementsByTagName("title").at(0);
      if (title)
        title.textContent = textContent2;
      else {
        head.insertBefore(
          this.createElement("title"),
          head.firstChild
        ).textContent = textContent2;
      }
    }
    createElement(localName, options) {
      const builtin = !!(options && options.is);
      const element = createHTMLElement$1(this, builtin, localName, options);
      if (builtin)
        element.setAttribute("is", options.is);
      return element;
    }
  };
  var SVGDocument = class extends Document$1 {
    constructor() {
      super("image/svg+xml");
    }
    toString() {
      return this[MIME].docType + super.toString();
    }
  };
  var XMLDocument = class extends Document$1 {
    constructor() {
      super("text/xml");
    }
    toString() {
      return this[MIME].docType + super.toString();
    }
  };
  var DOMParser = class _DOMParser {
    /** @typedef {{ "text/html": HTMLDocument, "image/svg+xml": SVGDocument, "text/xml": XMLDocument }} MimeToDoc */
    /**
     * @template {keyof MimeToDoc} MIME
     * @param {string} markupLanguage
     * @param {MIME} mimeType
     * @returns {MimeToDoc[MIME]}
     */
    parseFromString(markupLanguage, mimeType, globals = null) {
      let isHTML = false, document3;
      if (mimeType === "text/html") {
        isHTML = true;
        document3 = new HTMLDocument();
      } else if (mimeType === "image/svg+xml")
        document3 = new SVGDocument();
      else
        document3 = new XMLDocument();
      document3[DOM_PARSER] = _DOMParser;
      if (globals)
        document3[GLOBALS] = globals;
      if (isHTML && markupLanguage === "...")
        markupLanguage = "<!doctype html><html><head></head><body></body></html>";
      return markupLanguage ? parseFromString(document3, isHTML, markupLanguage) : document3;
    }
  };
  var { parse } = JSON;
  var parseHTML = (html3, globals = null) => new DOMParser().parseFromString(
    html3,
    "text/html",
    globals
  ).defaultView;
  function Document4() {
    illegalConstructor();
  }
  setPrototypeOf(Document4, Document$1).prototype = Document$1.prototype;

  // ../view/language.js
  var catalogue = globalThis.cartsWords ?? {};
  var FORMS = "\0";
  var RULE = catalogue["\0"] ?? "";
  function tr(sentence, values = {}) {
    return filled(catalogue[sentence] ?? sentence, values);
  }
  function counted(one, more, n, values = {}) {
    return filled(form(one, more, n), { n, ...values });
  }
  function form(one, more, n) {
    const ours = catalogue[more]?.split(FORMS);
    if (!ours) return n === 1 ? one : more;
    const english = n === 1 ? 0 : 1;
    const asked = RULE ? Number(RULE[n < RULE.length ? n : 100 + n % 100]) : english;
    return String(ours[Math.min(asked, ours.length - 1)]);
  }
  function told(sentence) {
    if (typeof sentence === "string") return catalogue[sentence] ?? sentence;
    const values = Object.entries(sentence.values).map(([name, value]) => [name, told(value)]);
    const { code, one } = sentence;
    const n = Number(String(sentence.values.n).replace(/,/g, ""));
    const template = one ? form(one, code, n) : catalogue[code] ?? code;
    return filled(template, Object.fromEntries(values));
  }
  function inRow(parts2) {
    const [head = "", ...tail3] = parts2;
    return tail3.reduce((first, second) => tr("{first}, {second}", { first, second }), head);
  }
  function ended(sentence) {
    return tr("{sentence}.", { sentence });
  }
  function filled(template, values) {
    return template.replace(/\{(\w+)\}/g, (whole, name) => String(values[name] ?? whole));
  }

  // ../view/markup.js
  var ESCAPED = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;" };
  var Markup = class {
    constructor(text3) {
      this.text = text3;
    }
    toString() {
      return this.text;
    }
  };
  function html(strings, ...values) {
    let written = strings[0] ?? "";
    values.forEach((value, k) => {
      const quote = strings[k]?.endsWith("=") ? '"' : "";
      written += quote + asText(value) + quote + (strings[k + 1] ?? "");
    });
    return new Markup(written);
  }
  function asText(value) {
    if (Array.isArray(value)) return value.map(asText).join("");
    if (value instanceof Markup) return value.text;
    if (value === false || value === null || value === void 0) return "";
    return String(value).replace(/[&<>"']/g, (sign) => ESCAPED[sign] ?? sign);
  }

  // ../view/numbers.js
  var SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  var NOISE = 1e-9;
  var MAX_DECIMALS = 12;
  var SLOW = 0.01;
  function exponent(value) {
    return value ? Number(Math.abs(value).toExponential(16).split("e")[1]) : 0;
  }
  function fixed(value, decimals) {
    const text3 = Math.abs(value).toFixed(decimals);
    return value < 0 && /[1-9]/.test(text3) ? `−${text3}` : text3;
  }
  function decimalsFor(scale, figures2 = 3) {
    return Math.min(MAX_DECIMALS, Math.max(0, figures2 - 1 - exponent(scale)));
  }
  function short(value, figures2 = 3) {
    const power3 = exponent(value);
    if (value && (power3 <= -4 || power3 >= 6)) {
      const [digits = "", tens] = Math.abs(value).toExponential(figures2 - 1).split("e");
      return `${value < 0 ? "−" : ""}${trim(digits)} × 10${superscript(Number(tens))}`;
    }
    return trim(fixed(value, Math.max(0, figures2 - 1 - power3)));
  }
  function figures(value, count = 3) {
    const power3 = exponent(value);
    return power3 <= -4 || power3 >= 6 ? short(value, count) : fixed(value, decimalsFor(value, count));
  }
  function superscript(power3) {
    const digits = String(Math.abs(power3)).replace(/\d/g, (d) => SUPERSCRIPT[Number(d)] ?? "");
    return power3 < 0 ? `⁻${digits}` : digits;
  }
  function decimalsOf(value, figures2 = 6) {
    const text3 = Math.abs(value).toFixed(decimalsFor(value, figures2));
    return trim(text3).split(".")[1]?.length ?? 0;
  }
  function speedUnit(scale) {
    return scale <= SLOW ? [1e-3, "mm/s"] : [1, "m/s"];
  }
  function trim(text3) {
    return text3.includes(".") ? text3.replace(/\.?0+$/, "") : text3;
  }
  function px(value, decimals = 1) {
    const factor = 10 ** decimals;
    const rounded = Math.floor(value * factor + 0.5) / factor;
    return String(rounded === 0 ? 0 : rounded);
  }

  // ../view/cost/methods.js
  var METHODS = {
    exact: {
      label: tr("exact, closed form"),
      mark: "M0-6L1.6-2 6-2 2.5 1 4 6 0 3-4 6-2.5 1-6-2-1.6-2Z",
      colour: "#0072b2"
    },
    "exact-run": { label: tr("exact, any scene"), mark: "M0-5L5 0 0 5-5 0Z", colour: "#0072b2" },
    certified: {
      label: tr("certificate, proved"),
      mark: "M0-6L5.2-3V3L0 6-5.2 3V-3Z",
      colour: "#0072b2"
    },
    euler: { label: "Euler", mark: "M-4-4H4V4H-4Z", colour: "#c04a00" },
    "semi-implicit": { label: tr("semi-implicit Euler"), mark: "M0-5L5 4H-5Z", colour: "#00805d" },
    verlet: { label: tr("velocity Verlet"), mark: "M0 5L5-4H-5Z", colour: "#a8457f" },
    yoshida: {
      label: tr("Yoshida, order 4, symplectic"),
      mark: "M-5 0L0-5 5 0M-5 4L0-1 5 4 0 2Z",
      colour: "#a8457f"
    },
    richardson: {
      label: "Verlet + Richardson",
      mark: "M-5-4H5V-1H-5ZM-5 1H5V4H-5Z",
      colour: "#8a5f00"
    },
    rk4: { label: "RK4", mark: "M-4.5 0a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0-9 0Z", colour: "#8a5f00" },
    "rk4-events": {
      label: tr("RK4 + located touches"),
      mark: "M-5-1.5H-1.5V-5H1.5V-1.5H5V1.5H1.5V5H-1.5V1.5H-5Z",
      colour: "#2779a7"
    },
    rk45: {
      label: tr("adaptive RK45 + located touches"),
      mark: "M-5-3.5H5L0 0L5 3.5H-5L0 0Z",
      colour: "#6b3f7d"
    },
    adaptive: {
      label: tr("adaptive DOP853 + located touches"),
      mark: "M-5 0L-1.5-4H1.5L5 0 1.5 4H-1.5Z",
      colour: "#555"
    }
  };
  var STEPLESS = ["exact", "exact-run", "certified"];
  var stepping = () => Object.keys(METHODS).filter((name) => !STEPLESS.includes(name));

  // ../view/cost/figure.js
  var [WIDTH, HEIGHT] = [520, 380];
  var [LEFT, TOP, RIGHT, BOTTOM] = [62, 14, 506, 330];
  var FLOOR = 1e-17;
  var [LOW_X, HIGH_X] = [0.5, 1e6];
  var HIGH_Y = 10;
  var TIMES = [0, 1, 2, 3, 4, 5, 6];
  var ERRORS = [-17, -15, -13, -11, -9, -7, -5, -3, -1, 1];
  var LEGEND = 18;
  function xAt(ratio) {
    const part = Math.log(Math.max(ratio, LOW_X) / LOW_X) / Math.log(HIGH_X / LOW_X);
    return LEFT + Math.min(1, part) * (RIGHT - LEFT);
  }
  function yAt(error) {
    const seen = Math.min(HIGH_Y, Math.max(error, FLOOR));
    return BOTTOM - Math.log(seen / FLOOR) / Math.log(HIGH_Y / FLOOR) * (BOTTOM - TOP);
  }
  function errorOf(row2) {
    return row2.error_v ?? (row2.method === "exact" ? 0 : null);
  }
  function lineOf(rows, method, floor = 0) {
    const points = rows.filter((row2) => row2.method === method && errorOf(row2) !== null).map((row2) => [px(xAt(row2.time_ratio)), px(yAt(errorOf(row2) || floor))]);
    return { line: points.map(([x, y], k) => `${k ? "L" : "M"}${x} ${y}`).join(""), points };
  }
  function levelAt(floor) {
    return floor ? `M${LEFT} ${px(yAt(floor))}H${RIGHT}` : "";
  }
  function digitText(factor) {
    return factor ? tr("one more digit: × {factor}", { factor: short(factor, 2) }) : "";
  }
  function grid() {
    return {
      x: TIMES.map((k) => [px(xAt(10 ** k)), power(k)]),
      y: ERRORS.map((k) => [px(yAt(10 ** k)), 10 ** k > FLOOR ? power(k) : "0"])
    };
  }
  function power(exponent2) {
    if (exponent2 === 0 || exponent2 === 1) return exponent2 ? "10" : "1";
    return `10${superscript(exponent2)}`;
  }
  function standalone({ title, rows, floor, digits = {} }) {
    const lines3 = Object.entries(METHODS).map(([name, method]) => ({ ...method, ...lineOf(rows, name, floor), digit: digits[name] })).filter(({ points }) => points.length);
    const height = HEIGHT + LEGEND * Math.ceil(lines3.length / 2) + 8;
    const { x, y } = grid();
    const series = lines3.map(({ line: line2, points, mark, colour, label, digit }, k) => {
      const legend2 = [px(LEFT + 240 * (k % 2)), px(HEIGHT + 8 + LEGEND * Math.floor(k / 2))];
      const marks3 = [...points, legend2].map(
        ([across3, down]) => html`<path transform="translate(${across3} ${down})" d=${mark} fill=${colour}/>`
      );
      return html`<path d=${line2} fill="none" stroke=${colour}/>${marks3}<text x=${legend2[0]} y=${legend2[1]} dx="12" dy="4">${label}${digit && ` (a digit: × ${short(digit, 2)})`}</text>`;
    });
    return html`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${px(height)}" width=${WIDTH} height=${px(height)} font-family="sans-serif" font-size="12"><title>${title}: error against time</title><rect width="100%" height="100%" fill="#fff"/><rect x=${LEFT} y=${TOP} width=${RIGHT - LEFT} height=${BOTTOM - TOP} fill="none" stroke="#55585e"/>${x.map(
      ([at, text3]) => html`<path d="M${at} ${TOP}V${BOTTOM}" stroke="#e4e6e9"/><text x=${at} y=${BOTTOM + 16} text-anchor="middle">${text3}</text>`
    )}${y.map(
      ([at, text3]) => html`<path d="M${LEFT} ${at}H${RIGHT}" stroke="#e4e6e9"/><text x=${LEFT - 7} y=${at} dy="4" text-anchor="end">${text3}</text>`
    )}<path d=${levelAt(floor)} stroke="#55585e" stroke-dasharray="2 3"/>${floor && html`<text x=${RIGHT - 4} y=${px(yAt(floor) - 4)} text-anchor="end">rounding of a double</text>`}<text x=${RIGHT} y=${BOTTOM + 34} text-anchor="end">time, as a multiple of the exact outcome’s</text><text transform="translate(14 ${(TOP + BOTTOM) / 2}) rotate(-90)" text-anchor="middle">largest error of a velocity in m/s</text>${series}</svg>
`;
  }

  // ../view/skeleton/mark.js
  var liveMark = () => html`<span class="carts-mark" role="img" aria-label=${tr("not live yet")}><span class="carts-mark-text" aria-hidden="true">${tr("live")}</span></span>`;

  // ../view/cost/breaks.js
  var [WIDTH2, HEIGHT2] = [520, 372];
  var [LEFT2, TOP2, RIGHT2, BOTTOM2] = [62, 10, 510, 322];
  var TICKS_Y = BOTTOM2 + 16;
  var MADE = tr("energy was made");
  var DIGITS = [0, 1, 2, 3, 4, 5, 6, 7, 8];
  var UNITS = { stiffness: "N/m", mass: "kg" };
  var cell = (count) => ({ wide: (RIGHT2 - LEFT2) / count, high: (BOTTOM2 - TOP2) / count });
  function squares({ parts: parts2 }, map, method) {
    const { wide, high } = cell(parts2.length);
    const paths = {};
    [...map.letters[method] ?? ""].forEach((letter, k) => {
      const [column, row2] = [Math.floor(k / parts2.length), k % parts2.length];
      const [x, y] = [px(LEFT2 + column * wide), px(BOTTOM2 - (row2 + 1) * high)];
      const box2 = `M${x} ${y}h${px(wide)}v${px(high)}h-${px(wide)}Z`;
      paths[letter] = (paths[letter] ?? "") + box2;
    });
    return Object.entries(paths).sort();
  }
  function theory({ parts: parts2, limits }, map, method) {
    const { wide } = cell(parts2.length);
    const limit = limits[method];
    const path3 = (steps) => steps.map((h, k) => [LEFT2 + (k + 0.5) * wide, yOf(parts2, h)]).filter(([, y]) => Number(y) >= TOP2 && Number(y) <= BOTTOM2).map(([x, y], k) => `${k ? "L" : "M"}${px(Number(x))} ${px(Number(y))}`).join("");
    return [path3(map.lines.contact), limit ? path3(map.lines.swing.map((h) => h * limit)) : ""];
  }
  function yOf(parts2, h) {
    const [short_, long] = [1 / Number(parts2[0]), 1 / Number(parts2.at(-1))];
    const part = Math.log(h / short_) / Math.log(long / short_);
    const { high } = cell(parts2.length);
    return BOTTOM2 - high / 2 - part * (BOTTOM2 - TOP2 - high);
  }
  function valueText(map, value) {
    const unit = UNITS[map.path.at(-1) ?? ""];
    return unit ? `${short(value)} ${unit}` : short(value);
  }
  var digitsText = (n) => counted("1 right digit", "{n} right digits", n);
  function ticks(map) {
    const [low, high] = [Number(map.values[0]), Number(map.values.at(-1))];
    const { wide } = cell(map.values.length);
    const grows = high / low > 100 && map.path.at(-1) !== "restitution";
    const places = grows ? [-3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7, 8].map((k) => 10 ** k) : [0.2, 0.4, 0.6, 0.8, 1];
    const part = (v) => grows ? Math.log(v / low) / Math.log(high / low) : (v - low) / (high - low);
    return places.filter((v) => part(v) > -0.03 && part(v) < 1.03).map((v) => [
      LEFT2 + wide / 2 + part(v) * (RIGHT2 - LEFT2 - wide),
      grows && (v >= 1e3 || v < 0.01) ? `10${superscript(Math.round(Math.log10(v)))}` : short(v)
    ]);
  }
  function breaksPart(breaks) {
    const first = breaks.maps[0];
    const names = Object.keys(first.letters);
    const method = "verlet";
    const steps = [1e-3, 0.01, 0.1].map(
      (h) => html`<text class="carts-tick-y" x=${LEFT2 - 7} y=${px(yOf(breaks.parts, h) + 4)}>${short(h)}</text>`
    );
    const [contact, limit] = theory(breaks, first, method);
    return html`<div class="carts-cost-breaks">
<p class="carts-heading">${tr("Where methods break")}</p>
<div class="carts-cost-choice"><label>${tr("method")} <select autocomplete="off" class="carts-breaks-method" disabled>${names.map((name) => html`<option value=${name}${name === method && html` selected`}>${METHODS[name]?.label}</option>`)}</select></label>
<label>${tr("across")} <select autocomplete="off" class="carts-breaks-map" disabled>${breaks.maps.map(({ name }, k) => html`<option value=${k}>${name}</option>`)}</select></label></div>
<svg class="carts-breaks-picture" viewBox="0 0 ${WIDTH2} ${HEIGHT2}" width=${WIDTH2} height=${HEIGHT2} role="img" aria-label=${tr("right digits of the velocities for each step and each value; the lists below reach every point")}>
<g class="carts-breaks-squares">${squares(breaks, first, method).map(([kind2, d]) => html`<path class="carts-breaks-${kind2}" d=${d}/>`)}</g>
<path class="carts-breaks-contact" d=${contact}/><path class="carts-breaks-limit" d=${limit}/>
${steps}<g class="carts-breaks-ticks">${ticks(first).map(([x, text3]) => html`<text class="carts-tick-x" x=${px(x)} y=${TICKS_Y}>${text3}</text>`)}</g>
<text class="carts-unit carts-breaks-unit" x=${RIGHT2} y=${BOTTOM2 + 36} text-anchor="end">${unitText(first)}</text>
<text class="carts-unit" transform="translate(14 ${(TOP2 + BOTTOM2) / 2}) rotate(-90)" text-anchor="middle">${tr("step in s")}</text>
<rect class="carts-breaks-ring" visibility="hidden"/>
</svg>
<ul class="carts-cost-key">${DIGITS.map((k) => sample(`${k}`, SQUARE, k === 8 ? digitsText(k) : `${k}`))}${sample("x", SQUARE, MADE)}${sample("contact", DASH, tr("a step as long as the contact"))}${sample("limit", DASH, tr("limit of stability"))}</ul>
<div class="carts-cost-choice"><label>${tr("value")} <select autocomplete="off" class="carts-breaks-value" disabled>${first.values.map((value, k) => html`<option value=${k}>${valueText(first, value)}</option>`)}</select></label>
<label>${tr("steps in 1 s")} <select autocomplete="off" class="carts-breaks-step" disabled>${breaks.parts.map((n, k) => html`<option value=${k}>${n}</option>`)}</select></label> <button type="button" class="carts-button carts-breaks-run" disabled>${tr("Run it above")}</button></div>
<p class="carts-breaks-found" role="status"></p>
<pre class="carts-breaks-command" hidden></pre>
</div>`;
  }
  var [SQUARE, DASH] = ["M0 0H16V16H0Z", "M0 8H16"];
  function sample(kind2, d, text3) {
    return html`<li><svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path class="carts-breaks-${kind2}" d=${d}/></svg> ${text3}</li>`;
  }
  function unitText(map) {
    const unit = UNITS[map.path.at(-1) ?? ""];
    return unit ? tr("{label} in {unit}", { label: map.name, unit }) : map.name;
  }

  // ../view/cost/guess.js
  var ASKED = [0.01, 1e-4, 1e-6, 1e-9, 1e-12];
  var FIRST = 1e-6;
  var errorText = (error) => `10${superscript(Math.round(Math.log10(error)))} m/s`;
  function guess() {
    const errors = ASKED.map(
      (error) => html`<option value=${error}${error === FIRST && html` selected`}>${errorText(error)}</option>`
    );
    const methods = stepping().map(
      (name) => html`<option value=${name}>${METHODS[name]?.label}</option>`
    );
    const none = html`<option value="">${tr("choose")}</option>`;
    return html`<div class="carts-cost-guess" role="group" aria-label=${tr("your guess")} hidden>
<p>${tr("Say first how right you want it.")} <label>${tr("Velocities wrong by at most")} <select autocomplete="off" class="carts-cost-error">${errors}</select></label>
<label>${tr("Which method gets there in the least time?")} <select autocomplete="off" class="carts-cost-bet">${none}${methods}</select></label>
<label>${tr("How many times as long as the exact outcome?")} <input class="carts-cost-times carts-number" type="text" inputmode="numeric" size="6" autocomplete="off"></label></p>
<p class="carts-cost-answer"><button type="button" class="carts-button carts-cost-show">${tr("Show")}</button> <button type="button" class="carts-button carts-cost-skip">${tr("Show without a guess")}</button> <span class="carts-cost-verdict" role="status"></span></p>
</div>`;
  }

  // ../view/cost/words.js
  var [MANY, HUGE] = [1e3, 1e4];
  var FEW = 10;
  var FIRST2 = { method: "euler", parts: 103 };
  var ENDLESS = tr("beyond all numbers");
  function percent(part, whole) {
    return `${plain(100 * part / whole, 1)} %`;
  }
  var inParts = (start, most) => start > 0 && most < FEW * start;
  function joules(value) {
    return `${Math.abs(value) < 0.1 ? short(value) : plain(value, 3)} J`;
  }
  function plain(value, decimals) {
    return Math.abs(value) < HUGE ? fixed(value, decimals) : short(value);
  }
  function told2({ v, energy, evaluations }) {
    const speeds = Object.entries(v.stepped).map(([name, speed]) => {
      const got = speed === null ? ENDLESS : `${plain(speed, 4)} m/s`;
      return [
        tr("velocity of {name} at the end", { name }),
        got,
        `${plain(Number(v.exact[name]), 4)} m/s`
      ];
    });
    const { initial, stepped, exact, imbalance } = energy;
    const part = inParts(initial, exact);
    const amount2 = (value) => part ? percent(value, initial) : joules(value);
    return [
      ...speeds,
      [
        part ? tr("energy at the end, of that at the start") : tr("energy at the end"),
        stepped === null ? ENDLESS : amount2(stepped),
        amount2(exact)
      ],
      [tr("energy made from nothing"), imbalance === null ? ENDLESS : `${short(imbalance)} J`, "0 J"],
      [tr("times that all forces were computed"), String(evaluations), "0"]
    ];
  }
  function toleranceText(rtol) {
    return tr("tolerance {size}", { size: `1e${Math.round(Math.log10(rtol))}` });
  }
  function cells(row2, until) {
    let size = "–";
    if (row2.rtol) size = toleranceText(row2.rtol);
    else if (row2.step) size = `${short(until)} s / ${Math.round(until / row2.step)}`;
    const ratio = row2.time_ratio;
    return [
      METHODS[row2.method]?.label ?? row2.method,
      size,
      String(row2.evaluations),
      ratio >= MANY ? String(Math.round(ratio)) : short(ratio),
      errorText2(row2, row2.error_v),
      errorText2(row2, row2.energy_error)
    ];
  }
  function errorText2({ evaluations }, error) {
    if (error !== null) return short(error, 2);
    return evaluations ? ENDLESS : "–";
  }

  // ../view/cost/skeleton.js
  var PARTS = [19, 61, 103, 211, 499, 997, 9973];
  var TOLERANCES = [1e-6, 1e-9, 1e-12];
  function inside({ id, title, names, measured: measured2, rows, floor, digits = {}, run, breaks }) {
    const told3 = told2(run.header).map(
      ([head, got, real]) => html`<tr><th scope="row">${head}</th><td>${got}</td><td>${real}</td></tr>`
    );
    const said = measured2 && tr("Measured {when}.", { when: measured2 });
    return html`<div class="carts-cost-frame" role="group" aria-labelledby="${id}-title">
<div class="carts-top"><p class="carts-title" id="${id}-title">${title}</p>${liveMark()}</div>
<div class="carts-note" role="status" hidden></div>
${choice(names)}
<div class="carts-cost-world"><svg class="carts-cost-stage" viewBox="0 0 640 118" width="640" height="118" role="img" aria-label=${tr("the carts as stepped, and exactly as dashed outlines")}></svg></div>
<div class="carts-transport carts-cost-transport"><button type="button" class="carts-button carts-play carts-cost-play" disabled>${tr("Play")}</button><input type="range" class="carts-cost-scrub" min="0" max="1" step="any" value="0" aria-label=${tr("time")} disabled><span class="carts-cost-clock">0.00 s</span></div>
<p class="carts-cost-legend"><span class="carts-cost-solid"></span> ${tr("as stepped")} <span class="carts-cost-dashed"></span> ${tr("exactly")}</p>
<div class="carts-cost-body">
<div><p class="carts-heading">${tr("Energy of motion")}</p><svg class="carts-cost-energy" viewBox="0 0 400 190" width="400" height="190" role="img" aria-label=${tr("energy of motion against time, as stepped and exactly")}></svg></div>
<div class="carts-scroll"><table class="carts-table carts-cost-told"><thead><tr><td></td><th scope="col">${tr("as stepped")}</th><th scope="col">${tr("exactly")}</th></tr></thead><tbody>${told3}</tbody></table></div>
</div>
<div class="carts-cost-measure">
<p class="carts-heading">${tr("Error against time")}</p>
<p class="carts-cost-start"><button type="button" class="carts-button carts-cost-go" disabled>${tr("Measure on this computer")}</button> <button type="button" class="carts-button carts-cost-stop" hidden>${tr("Stop")}</button> <progress class="carts-cost-progress" max="1" value="0" aria-label=${tr("methods measured")} hidden></progress> <span class="carts-cost-say" role="status">${said}</span></p>
${guess()}
<div class="carts-cost-known">
${figure(rows, floor, digits)}
${table(rows, run.header.until)}
</div>
</div>
${breaks && breaksPart(breaks)}
<noscript><p class="carts-noscript">${tr("The figure and the tables show what was measured. Trying and measuring here needs JavaScript.")}</p></noscript>
</div>`;
  }
  var partText = (n) => tr("run / {n}", { n });
  function choice(names) {
    const scenes = Object.entries(names).map(
      ([name, text3]) => html`<option value=${name}>${text3}</option>`
    );
    const methods = stepping().map(
      (name) => html`<option value=${name}${name === FIRST2.method && html` selected`}>${METHODS[name]?.label}</option>`
    );
    const parts2 = PARTS.map(
      (n) => html`<option value=${n}${n === FIRST2.parts && html` selected`}>${partText(n)}</option>`
    );
    const tolerances = TOLERANCES.map(
      (rtol) => html`<option value=${rtol}>${toleranceText(rtol)}</option>`
    );
    return html`<div class="carts-cost-choice">
<label>${tr("scene")} <select autocomplete="off" class="carts-cost-scene" disabled>${scenes}</select></label>
<label>${tr("method")} <select autocomplete="off" class="carts-cost-method" disabled>${methods}</select></label>
<label>${tr("step")} <select autocomplete="off" class="carts-cost-step" disabled>${parts2}</select><select autocomplete="off" class="carts-cost-rtol" aria-label=${tr("tolerance")} disabled hidden>${tolerances}</select></label>
</div>`;
  }
  function figure(rows, floor, digits) {
    const { x, y } = grid();
    const methods = Object.entries(METHODS);
    const series = methods.map(([name, { mark }]) => {
      const { line: line2, points } = lineOf(rows, name, floor);
      const marks3 = points.map(
        ([across3, down]) => html`<path class="carts-cost-point" transform="translate(${across3} ${down})" d=${mark}/>`
      );
      return html`<g class="carts-cost-of-${name}" data-method=${name}><path class="carts-cost-line" d=${line2}/>${marks3}</g>`;
    });
    const key2 = methods.map(
      ([name, { mark, label }]) => html`<li class="carts-cost-of-${name}"><svg viewBox="-8 -8 16 16" width="16" height="16" aria-hidden="true"><path class="carts-cost-point" d=${mark}/></svg> ${label} <span class="carts-cost-digit carts-quiet" data-of=${name}>${digitText(digits[name])}</span></li>`
    );
    return html`<svg class="carts-cost-figure" viewBox="0 0 ${WIDTH} ${HEIGHT}" width=${WIDTH} height=${HEIGHT} role="img" aria-label=${tr("largest error of a velocity against time, one line per method; the numbers are in the table below")}>
${x.map(([at, text3]) => html`<path class="carts-grid" d="M${at} ${TOP}V${BOTTOM}"/><text class="carts-tick-x" x=${at} y=${BOTTOM + 16}>${text3}</text>`)}
${y.map(([at, text3]) => html`<path class="carts-grid" d="M${LEFT} ${at}H${RIGHT}"/><text class="carts-tick-y" x=${LEFT - 7} y=${Number(at) + 4}>${text3}</text>`)}
<text class="carts-unit" x=${RIGHT} y=${BOTTOM + 36} text-anchor="end">${tr("time, as a multiple of the exact outcome’s")}</text>
<text class="carts-unit" transform="translate(14 ${(TOP + BOTTOM) / 2}) rotate(-90)" text-anchor="middle">${tr("largest error of a velocity in m/s")}</text>
<path class="carts-cost-floor" d=${levelAt(floor)}/><text class="carts-cost-floor-name carts-quiet" x=${RIGHT - 4} y=${px(yAt(floor || 1e-16) - 5)} text-anchor="end">${floor && tr("rounding of a double")}</text><path class="carts-cost-asked"/>
<g class="carts-cost-series">${series}</g>
<circle class="carts-cost-ring" r="9" visibility="hidden"/>
</svg>
<ul class="carts-cost-key">${key2}</ul>`;
  }
  function table(rows, until) {
    const lines3 = rows.map((row2) => {
      const [head, ...values] = cells(row2, until);
      return html`<tr><th scope="row">${head}</th>${values.map((value) => html`<td>${value}</td>`)}</tr>`;
    });
    const heads2 = [
      tr("method"),
      tr("step"),
      tr("forces computed"),
      tr("time"),
      tr("error of v in m/s"),
      tr("error of energy, of the larger of start and end")
    ];
    return html`<details class="carts-more carts-cost-table"><summary>${tr("Table of all measurements")}</summary><div class="carts-scroll"><table class="carts-table"><thead><tr>${heads2.map((head) => html`<th scope="col">${head}</th>`)}</tr></thead><tbody>${lines3}</tbody></table></div></details>`;
  }

  // ../view/hard/words.js
  var VERDICTS = {
    right: tr("right"),
    "blows-up": tr("blows up"),
    "passes-through": tr("carts pass through each other"),
    misses: tr("misses contacts"),
    "makes-energy": tr("makes energy from nothing"),
    "loses-energy": tr("loses energy"),
    sticks: tr("carts stick together"),
    wrong: tr("wrong")
  };
  var UNITS2 = { v: " m/s", x: " m", last: " s", count: "" };
  var NAMES = {
    warmed: tr("warmed the bumpers"),
    count: tr("contacts"),
    last: tr("last contact")
  };
  var LOADING = tr("Python’s numpy and scipy are being loaded …");
  var COPY = tr("Copy");
  var COPIED = tr("Copied");
  function measure(what) {
    const { kind: kind2, name } = parts(what);
    if (kind2 === "v" || kind2 === "x") {
      const [last, first] = name.split("-");
      const of = (cart2 = "") => tr("{letter} of {cart}", { letter: kind2, cart: cart2 });
      return first ? `${of(last)} − ${of(first)}` : of(name);
    }
    return NAMES[kind2] ?? (kind2 === "work" ? tr("work of {name}", { name }) : kind2);
  }
  function parts(what) {
    const [kind2 = "", ...rest] = what.split(".");
    return { kind: kind2, name: rest.join(".") };
  }
  function amount(what, value, figures2) {
    const { kind: kind2 } = parts(what);
    if (kind2 === "count") return String(Math.round(value));
    return (short(value, figures2) + (UNITS2[kind2] ?? " J")).replaceAll(" ", " ");
  }
  function cameOut(wanted, got, figures2) {
    let worst = "";
    let [error, came] = [0, 0];
    for (const [k, [what, right]] of wanted.entries()) {
      const value = got[k];
      if (value === null || value === void 0) return "";
      const distance = Math.abs(value - right);
      if (!worst || distance > error) [worst, error, came] = [what, distance, value];
    }
    const off = error ? tr("off by {amount}", { amount: amount(worst, error, 2) }) : tr("no error");
    return tr("{quantity}: {amount}, {off}", {
      quantity: measure(worst),
      amount: amount(worst, came, figures2),
      off
    });
  }
  function exactCell(wanted, { got }) {
    return cameOut(wanted, got, 6);
  }
  function steppedCell(wanted, { verdict, got }) {
    return [VERDICTS[verdict] ?? verdict, verdict === "blows-up" ? "" : cameOut(wanted, got, 3)];
  }
  var METHODS2 = { euler: "Euler", "semi-implicit": tr("semi-implicit Euler"), rk4: "RK4" };
  var MOST_TOLD = 3;
  function expectedLines(wanted) {
    const lines3 = wanted.slice(0, MOST_TOLD).map(
      ([what, value]) => tr("{quantity}: {amount}", { quantity: measure(what), amount: amount(what, value, 6) })
    );
    const more = wanted.length - lines3.length;
    return more ? [...lines3, tr("and {n} more", { n: more })] : lines3;
  }

  // ../view/hard/skeleton.js
  var [MUST, EXACT] = [tr("must come out"), tr("exact")];
  var COLUMNS = 3 + Object.keys(METHODS2).length;
  function inside2({ id, title, groups }) {
    const count = groups.reduce((sum, { rows }) => sum + rows.length, 0);
    const all = tr("Run all {n} here", { n: count });
    const methods = Object.values(METHODS2).map((name) => html`<th scope="col">${name}</th>`);
    return html`<div class="carts-hard-frame" role="group" aria-labelledby="${id}-title">
<div class="carts-top"><p class="carts-title" id="${id}-title">${title}</p>${liveMark()}</div>
<div class="carts-note" role="status" hidden></div>
<p class="carts-hard-start"><button type="button" class="carts-button carts-hard-go" disabled>${all}</button> <button type="button" class="carts-button carts-hard-stop" hidden>${tr("Stop")}</button> <progress class="carts-hard-progress" max=${count} value="0" aria-label=${tr("cases run")} hidden></progress> <span class="carts-hard-say" role="status"></span></p>
<table class="carts-hard-table">
<thead><tr><th scope="col">${tr("case")}</th><th scope="col">${MUST}</th><th scope="col">${EXACT}</th>${methods}</tr></thead>
${groups.map(
      ({ name, rows }) => html`<tbody>
<tr class="carts-hard-group"><th scope="colgroup" colspan=${COLUMNS}>${name}</th></tr>
${rows.map(row)}</tbody>
`
    )}</table>
<noscript><p class="carts-noscript">${tr("The table shows what came out when this page was made. Running the cases here needs JavaScript.")}</p></noscript>
</div>`;
  }
  function row({ name, sentence, why, wanted, known: known2, yaml, commands }) {
    const lines3 = expectedLines(wanted).map((line2, k) => html`${k > 0 && html`<br>`}${line2}`);
    const heads2 = Object.values(METHODS2);
    const cells2 = known2.stepped.map((one, k) => {
      const [verdict, off] = steppedCell(wanted, one);
      return html`<td data-head=${heads2[k]} data-part="stepped" data-verdict=${one.verdict}><b>${verdict}</b> <span>${off}</span></td>`;
    });
    const step = short(known2.stepped[0]?.step ?? 0, 3);
    const steps = tr("The methods took steps of {step} s.", { step });
    const save = tr("Save this as {name}.yml, then:", { name });
    return html`<tr data-case=${name}><th scope="row"><b>${name}</b> ${sentence}</th>
<td data-head=${MUST}>${lines3}</td><td data-head=${EXACT} data-part="exact">${exactCell(wanted, known2.exact)}</td>${cells2}</tr>
<tr class="carts-hard-more"><td colspan=${COLUMNS}><details class="carts-more"><summary>${tr("Why, and the scene")}</summary><p>${why} ${steps}</p><pre tabindex="0">${yaml}</pre><p>${save}</p>${commands.map((command) => html`<pre tabindex="0">${command}</pre>`)}</details></td></tr>
`;
  }

  // ../view/scales.js
  var STEP_SLACK = 1e-9;
  var HEADROOM = 0.05;
  var NOUGHT = 1e-12;
  function axisDecimals(axis2) {
    return Math.max(0, -exponent(axis2.step));
  }
  function ticks2(axis2) {
    const first = Math.ceil(axis2.low / axis2.step - STEP_SLACK);
    const last = Math.floor(axis2.high / axis2.step + STEP_SLACK);
    const found = [];
    for (let k = first; k <= last; k += 1) found.push(k * axis2.step);
    return found;
  }
  function niceAbove(value) {
    const power3 = Number(`1e${exponent(value)}`);
    for (const factor of [1, 2, 5]) {
      if (value <= factor * power3 * (1 + STEP_SLACK)) return factor * power3;
    }
    return 10 * power3;
  }
  function axis(low, high, count) {
    const bottom = low < -NOUGHT ? low : 0;
    const above = high > NOUGHT ? high : 0;
    const top = above === bottom ? 1 : above;
    const room = HEADROOM * (top - bottom);
    return { low: bottom - room, high: top + room, step: niceAbove((top - bottom) / count) };
  }
  function span(low, high, count) {
    return { low, high, step: niceAbove((high - low) / count) };
  }

  // ../view/map/palette.js
  var NONE2 = [176, 176, 176];
  var ZERO2 = [32, 32, 32];
  var EDGE = 0.72;
  function sequential(count) {
    return Array.from({ length: count }, (_, k) => {
      const t = k / Math.max(1, count - 1);
      return oklch(0.3 + 0.64 * t, 0.09 + 0.05 * Math.sin(Math.PI * t), 268 - 165 * t);
    });
  }
  function diverging(centres) {
    const far = Math.max(...centres.map(Math.abs));
    return centres.map((centre) => {
      const size = Math.abs(centre / far);
      return oklch(0.97 - 0.47 * size, 0.145 * size, centre < 0 ? 250 : 52);
    });
  }
  function edge([red, green, blue]) {
    return [Math.round(EDGE * red), Math.round(EDGE * green), Math.round(EDGE * blue)];
  }
  function oklch(lightness, chroma, hue) {
    const angle = hue * Math.PI / 180;
    const [a, b] = [chroma * Math.cos(angle), chroma * Math.sin(angle)];
    const long = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
    const middle = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
    const short2 = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
    return [
      channel(4.0767416621 * long - 3.3077115913 * middle + 0.2309699292 * short2),
      channel(-1.2684380046 * long + 2.6097574011 * middle - 0.3413193965 * short2),
      channel(-0.0041960863 * long - 0.7034186147 * middle + 1.707614701 * short2)
    ];
  }
  function channel(linear) {
    const light = Math.min(1, Math.max(0, linear));
    const coded = light <= 31308e-7 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055;
    return Math.round(255 * coded);
  }

  // ../view/map/bands.js
  var BANDS = 12;
  var FLAT = 1e-9;
  function scaleFor(low, high) {
    const largest = Math.max(Math.abs(low), Math.abs(high));
    const flat = high - low <= FLAT * largest || largest === 0;
    const step = flat ? largest ? niceAbove(largest) : 1 : niceAbove((high - low) / BANDS);
    const first = Math.floor(low / step + STEP_SLACK);
    const last = Math.max(first + 1, Math.ceil(high / step - STEP_SLACK));
    const count = last - first;
    const centres = Array.from({ length: count }, (_, k) => (first + k + 0.5) * step);
    const around = Number(centres[0]) < 0 && Number(centres.at(-1)) > 0;
    return {
      low: first * step,
      step,
      count,
      colours: around ? diverging(centres) : sequential(count),
      zero: Math.min(count, Math.max(0, -first))
    };
  }
  function edges({ low, step, count }) {
    const first = Math.round(low / step);
    return Array.from({ length: count + 1 }, (_, k) => (first + k) * step);
  }
  function edgeDecimals(scale) {
    return Math.max(...edges(scale).map((one) => decimalsOf(one)));
  }

  // ../view/map/pixels.js
  var FINE = 400;
  var TORN = 3;
  function band(value, { low, step, count }) {
    if (Number.isNaN(value)) return count;
    const place2 = Math.floor((value - low) / step + STEP_SLACK);
    return Math.min(count - 1, Math.max(0, place2));
  }
  function torn(before2, a, b, after2, step) {
    const apart = Math.abs(b - a);
    if (apart <= TORN * step) return false;
    const beside2 = [a - before2, b - after2].map(Math.abs).filter(Number.isFinite);
    return !(apart <= TORN * (beside2.length ? Math.min(...beside2) : apart));
  }
  function between(values, lines3, count, factor, next, line2, step) {
    const fine = (count - 1) * factor + 1;
    const found = new Float64Array(lines3 * fine);
    for (let i = 0; i < lines3; i += 1) {
      const value = (k) => k < 0 || k >= count ? Number.NaN : Number(values[i * line2 + k * next]);
      for (let left = 0; left < count - 1; left += 1) {
        const [a, b] = [value(left), value(left + 1)];
        const apart = torn(value(left - 1), a, b, value(left + 2), step);
        for (let k = 0; k <= factor; k += 1) {
          const part = k / factor;
          const mixed = a * (1 - part) + b * part;
          found[i * fine + left * factor + k] = !apart ? mixed : part < 0.5 ? a : b;
        }
      }
    }
    return found;
  }
  function pixels(values, columns, scale) {
    const rows = values.length / columns;
    const factor = Math.max(1, Math.ceil(FINE / (Math.max(columns, rows) - 1)));
    const width = (columns - 1) * factor + 1;
    const height = (rows - 1) * factor + 1;
    const wide = between(values, rows, columns, factor, 1, columns, scale.step);
    const fine = between(wide, width, rows, factor, width, 1, scale.step);
    const bands = new Uint8Array(width * height);
    for (let y = 0; y < height; y += 1) {
      for (let x = 0; x < width; x += 1) {
        bands[y * width + x] = band(Number(fine[x * height + (height - 1 - y)]), scale);
      }
    }
    return { places: lines(bands, width, scale), width, height };
  }
  function lines(bands, width, { count, zero }) {
    const places = bands.slice();
    const line2 = 2 * count + 1;
    const compare = (at, other) => {
      const own = Number(bands[at]);
      const next = Number(bands[other]);
      if (next === own || own === count) return;
      if (next !== count && own >= zero !== next >= zero && Math.abs(own - next) === 1) {
        places[at] = line2;
        places[other] = line2;
      } else if (places[at] !== line2) places[at] = count + 1 + own;
    };
    for (let at = 0; at < bands.length; at += 1) {
      if ((at + 1) % width) compare(at, at + 1);
      if (at + width < bands.length) compare(at, at + width);
    }
    return places;
  }
  function palette({ colours }) {
    return [...colours, NONE2, ...colours.map(edge), ZERO2];
  }

  // ../view/map/words.js
  var SMALLER = 2;
  var EXACT2 = 12;
  function valueText2(value, { low, high }) {
    if (Number.isNaN(value)) return tr("no value");
    const most = decimalsFor(Math.max(Math.abs(low), Math.abs(high)) || 1) + SMALLER;
    const text3 = fixed(value, Math.min(decimalsFor(value || 1), most));
    return /[1-9]/.test(text3) ? text3 : fixed(0, most - SMALLER);
  }
  function shown(value, { per }) {
    return Number((value / per).toPrecision(EXACT2));
  }
  function axisDecimals2(axis2) {
    const [first = 0, second = 0] = axis2.values.map((value) => shown(value, axis2));
    return Math.max(decimalsOf(first), decimalsOf(second - first, 3));
  }
  function named({ label, unit }) {
    return unit ? tr("{label} in {unit}", { label, unit }) : label;
  }

  // ../view/map/figure.js
  var [LEFT3, TOP3, RIGHT3, BOTTOM3] = [58, 10, 388, 270];
  var WIDTH3 = 400;
  var [HEIGHT3, HEIGHT_OF_CURVE] = [370, 312];
  var [BAR_TOP, BAR_HEIGHT] = [322, 12];
  var TICKS = 5;
  var MOST_NUMBERS = 7;
  var BASELINE = 4;
  var heightOf = ({ axes: axes2 }) => axes2.length === 1 ? HEIGHT_OF_CURVE : HEIGHT3;
  var valueAxis = ({ low, high }) => axis(low, high, TICKS);
  function across(value, { low, high }) {
    return LEFT3 + (value - low) * ((RIGHT3 - LEFT3) / (high - low));
  }
  function up(value, { low, high }) {
    return BOTTOM3 - (value - low) * ((BOTTOM3 - TOP3) / (high - low));
  }
  function curve(facts, points, values) {
    const along = facts.axes[0];
    if (!along) return "";
    const [x, y] = [span(along.low, along.high, 1), valueAxis(facts)];
    let path3 = "";
    let pen = "M";
    for (const [k, point] of points.entries()) {
      const [before2, last, value, next] = [k - 2, k - 1, k, k + 1].map((at) => Number(values[at]));
      if (torn(before2, last, value, next, (y.high - y.low) / TICKS)) pen = "M";
      if (value >= y.low && value <= y.high) {
        path3 += `${pen}${px(across(shown(point, along), x))} ${px(up(value, y))}`;
        pen = "L";
      } else pen = "M";
    }
    return path3;
  }
  function under(facts, picture2) {
    const [first, second] = facts.axes;
    const x = span(first?.low ?? 0, first?.high ?? 1, TICKS);
    const y = second ? span(second.low, second.high, TICKS) : valueAxis(facts);
    const labels2 = [first ? named(first) : "", second ? named(second) : named(facts)];
    const height = heightOf(facts);
    const [bottom, right] = picture2 ? [BOTTOM3, LEFT3] : [TOP3, RIGHT3];
    const image = html`<image href=${picture2} x=${LEFT3} y=${TOP3} width=${RIGHT3 - LEFT3} height=${BOTTOM3 - TOP3} preserveAspectRatio="none"/>
`;
    const columns = ticks2(x).map((tick) => {
      const at = px(across(tick, x));
      return html`<path class="carts-grid" d="M${at} ${bottom}V${BOTTOM3 + 4}"/><text class="carts-tick-x" x=${at} y=${BOTTOM3 + 16}>${fixed(tick, axisDecimals(x))}</text>`;
    });
    const rows = ticks2(y).map((tick) => {
      const at = up(tick, y);
      return html`<path class="carts-grid" d="M${LEFT3 - 4} ${px(at)}H${right}"/><text class="carts-tick-y" x=${LEFT3 - 7} y=${px(at + BASELINE)}>${fixed(tick, axisDecimals(y))}</text>`;
    });
    return html`<svg class="carts-map-under" viewBox="0 0 ${WIDTH3} ${height}" width=${WIDTH3} height=${height} aria-hidden="true" focusable="false">
${picture2 !== "" && image}${columns}
${rows}
<text class="carts-unit" x=${RIGHT3} y=${BOTTOM3 + 31} text-anchor="end">${labels2[0]}</text>
<text class="carts-unit" transform="translate(13 ${(TOP3 + BOTTOM3) / 2}) rotate(-90)" text-anchor="middle">${labels2[1]}</text>
${second && bar(facts)}
</svg>`;
  }
  function bar(facts) {
    const scale = scaleFor(facts.low, facts.high);
    const width = (RIGHT3 - LEFT3) / scale.count;
    const numbers = edges(scale);
    const every = Math.ceil(scale.count / MOST_NUMBERS);
    const zero = Math.max(
      0,
      numbers.findIndex((number) => Math.abs(number) < 0.5 * scale.step)
    );
    const parts2 = numbers.map((number, k) => {
      const x = px(LEFT3 + k * width, 2);
      const colour = scale.colours[k];
      const band4 = colour && html`<rect x=${x} y=${BAR_TOP} width=${px(width, 2)} height=${BAR_HEIGHT} fill=${hex(colour)}/>`;
      const notch = (k - zero) % every === 0 && html`<path class="carts-map-notch" d="M${x} ${BAR_TOP}v${BAR_HEIGHT}"/><text class="carts-tick-x" x=${x} y=${BAR_TOP + BAR_HEIGHT + 12}>${fixed(number, edgeDecimals(scale))}</text>`;
      return html`${band4}${notch}`;
    });
    return html`${parts2}
<text class="carts-unit" x=${RIGHT3} y=${BAR_TOP + BAR_HEIGHT + 26} text-anchor="end">${named(facts)}</text>`;
  }
  var hex = (colour) => `#${colour.map((part) => part.toString(16).padStart(2, "0")).join("")}`;

  // ../view/map/table.js
  var COLUMNS2 = 6;
  var ROWS = 11;
  function spread(count, most) {
    const wanted = Math.min(most, count);
    return Array.from(
      { length: wanted },
      (_, k) => Math.floor(k * (count - 1) / (wanted - 1) + 0.5)
    );
  }
  function tableOf(columns, rows, axisText2, valueText3) {
    if (rows === 1) {
      const lines4 = spread(columns, 2 * ROWS - 1).map((k) => [axisText2(0, k), valueText3(k)]);
      return { head: [], lines: lines4 };
    }
    const across3 = spread(columns, COLUMNS2);
    const lines3 = spread(rows, ROWS).map((row2) => [
      axisText2(1, row2),
      ...across3.map((k) => valueText3(row2 * columns + k))
    ]);
    return { head: across3.map((k) => axisText2(0, k)), lines: lines3 };
  }

  // ../view/map/skeleton.js
  function inside3(facts, draw, picture2) {
    const { id, title, why } = draw;
    return html`<div class="carts-map-frame" role="group" aria-labelledby="${id}-title">
<div class="carts-top"><p class="carts-title" id="${id}-title">${title}</p>${liveMark()}</div>
<div class="carts-note" role="status" hidden></div>
<div class="carts-map-body">
<div class="carts-map-figure" role="group" aria-label=${named(facts)}>
${under(facts, picture2)}
${over(facts, draw)}
</div>
${side(facts, draw)}
</div>
${table2(facts, draw)}
<details class="carts-more carts-map-model"><summary>${tr("How this was computed")}</summary><p class="carts-map-why">${why}</p></details>
<noscript><p class="carts-noscript">${tr("The picture and the table show the values. Asking single points needs JavaScript.")}</p></noscript>
</div>`;
  }
  var valueAt = ({ values }, place2) => values[place2] ?? Number.NaN;
  function axisText(facts, axis2, place2) {
    const along = facts.axes[axis2];
    return along ? fixed(shown(Number(along.values[place2]), along), axisDecimals2(along)) : "";
  }
  function over(facts, draw) {
    const height = heightOf(facts);
    const all = draw.values.map((value) => value ?? Number.NaN);
    const line2 = facts.axes.length === 1 ? curve(facts, facts.axes[0]?.values ?? [], all) : "";
    return html`<svg class="carts-map-over" viewBox="0 0 ${WIDTH3} ${height}" width=${WIDTH3} height=${height} aria-hidden="true" focusable="false">
<rect class="carts-map-edge" x=${LEFT3} y=${TOP3} width=${RIGHT3 - LEFT3} height=${BOTTOM3 - TOP3}/>
<path data-part="curve" class="carts-curve" d=${line2}/>
<g data-part="cross"><path data-part="lines" class="carts-map-cross" d=""/><circle data-part="point" class="carts-map-point" r="6" cx="0" cy="0" visibility="hidden"/></g>
</svg>`;
  }
  function side(facts, { id }) {
    const { label, unit, axes: axes2, here, of, controls } = facts;
    const points = axes2.map(({ set, label: name, unit: measured2, values }, k) => {
      const place2 = here[k] ?? 0;
      const text3 = axisText(facts, k, place2);
      const range = html`min="0" max=${values.length - 1} step="1" value=${place2}`;
      return slider({ id, set, label: name, unit: measured2, range, text: text3 }, " carts-map-axis");
    });
    const further = controls.map(({ set, label: name, unit: measured2, low, high, step, value }) => {
      const decimals = Math.max(...[step, low, value].map((one) => decimalsOf(one)));
      const range = html`min=${low} max=${high} step=${step} value=${value}`;
      return slider(
        { id, set, label: name, unit: measured2, range, text: fixed(value, decimals) },
        ""
      );
    });
    const ids = axes2.map(({ set }) => `${id}-${set.replaceAll(".", "-")} `).join("");
    const at = valueText2(facts.at ?? Number.NaN, facts);
    return html`<div class="carts-map-side">
<p class="carts-map-start"><button type="button" class="carts-button carts-map-open" hidden>${tr("Open the map")}</button> <span class="carts-map-wait" hidden>${tr("The map is a picture until you open it. Then every point can be asked for its value.")}</span></p>
<p class="carts-heading">${tr("One point of the map")}</p>
${points}<p class="carts-map-value"><span>${label}</span> <output class="carts-map-number" for=${ids}>${facts.at === null ? at : `${at} ${unit}`}</output></p>
<progress class="carts-map-progress" max="1" value="1" aria-label=${tr("points computed")}></progress>
${of && html`<p class="carts-map-start"><button type="button" class="carts-button carts-map-run" disabled>${tr("Run this point")}</button> <a href="#${of}">${tr("the scene")}</a></p>`}
${controls.length > 0 && html`<p class="carts-heading">${tr("All points of the map")}</p>`}
${further}</div>`;
  }
  function slider({ id, set, label, unit, range, text: text3 }, more) {
    const box2 = `${id}-${set.replaceAll(".", "-")}`;
    const spoken = tr("{label}, slider", { label });
    return html`<div class="carts-control${more}" data-set=${set}>
<label for=${box2}>${label}</label>
<input type="range" class="carts-slider" ${range} aria-label=${spoken} aria-valuetext=${`${text3} ${unit}`.trim()} disabled>
<span class="carts-typed"><input type="text" class="carts-number-box" id=${box2} inputmode="decimal" autocomplete="off" spellcheck="false" value=${text3.replace("−", "-")} aria-label=${named({ label, unit })} disabled> <span class="carts-unit-text">${unit}</span></span>
<p class="carts-error" hidden></p>
</div>
`;
  }
  function table2(facts, draw) {
    const [first, second] = facts.axes;
    const columns = first?.values.length ?? 0;
    const { head, lines: lines3 } = tableOf(
      columns,
      second?.values.length ?? 1,
      (axis2, place2) => axisText(facts, axis2, place2),
      (place2) => valueText2(valueAt(draw, place2), facts)
    );
    const heads2 = second ? head : [facts.label];
    const across3 = html`<tr><td></td><th scope="colgroup" colspan=${heads2.length}>${first && named(first)}</th></tr>`;
    const rows = lines3.map(
      ([name, ...cells2]) => html`<tr><th scope="row">${name}</th>${cells2.map((cell2) => html`<td>${cell2}</td>`)}</tr>`
    );
    const summary = tr("Table: {quantity}", { quantity: named(facts) });
    return html`<details class="carts-more carts-map-table"><summary>${summary}</summary>
<div class="carts-scroll"><table class="carts-table"><thead>
${second && across3}
<tr><th scope="col">${named(second ?? first ?? facts)}</th>${heads2.map((cell2) => html`<th scope="col">${cell2}</th>`)}</tr></thead>
<tbody>${rows}</tbody></table></div></details>`;
  }

  // ../view/bodies.js
  var THINGS = {
    foam: () => ({ body: tr("the foam"), brief: tr("foam") }),
    spring: () => ({ body: tr("the spring"), brief: tr("spring") }),
    board: () => ({ body: tr("the board"), brief: tr("board") })
  };
  function isWall(name) {
    return name === "left" || name === "right";
  }
  function whatIs(name, { left_is = "wall", right_is = "wall" }) {
    return name === "left" ? left_is : right_is;
  }
  function body(name, track) {
    if (!isWall(name)) return name;
    const thing = thingAt(name, track, "body");
    if (thing) return thing;
    if (!hasTwoWalls(track)) return tr("the wall");
    return name === "left" ? tr("the left wall") : tr("the right wall");
  }
  function brief(name, track) {
    if (!isWall(name)) return name;
    const thing = thingAt(name, track, "brief");
    if (thing) return thing;
    if (!hasTwoWalls(track)) return tr("wall");
    return name === "left" ? tr("left wall") : tr("right wall");
  }
  function hasTwoWalls(track) {
    return ["left", "right"].every(
      (side2) => track[side2] === "wall" && whatIs(side2, track) === "wall"
    );
  }
  function isWord(name) {
    return name.length > 2;
  }
  function kind(name, track) {
    return THINGS[whatIs(name, track)]?.().brief ?? tr("wall");
  }
  function thingAt(name, track, form2) {
    const thing = THINGS[whatIs(name, track)]?.()[form2];
    if (!thing || whatIs("left", track) !== whatIs("right", track)) return thing ?? "";
    return name === "left" ? tr("{thing} on the left", { thing }) : tr("{thing} on the right", { thing });
  }
  function forceOn(on, by) {
    return tr("force on {on} by {by}", { on, by });
  }
  function listed(names) {
    const [first = "", second] = names;
    if (second === void 0) return first;
    const rest = inRow(names.slice(0, -1));
    return tr("{first} and {last}", { first: rest, last: String(names.at(-1)) });
  }
  function onBy(on, by, track) {
    return tr("on {on} by {by}", { on: body(on, track), by: body(by, track) });
  }
  function dashed(names, track) {
    return names.map((name) => brief(name, track)).join("–");
  }
  function bodiesOf(names, track) {
    return listed(names.map((name) => body(name, track)));
  }

  // ../view/measured/units.js
  var QUANTITY = {
    time: ["t", "s"],
    length: ["x", "m"],
    force: ["F", "N"],
    acceleration: ["a", "m/s²"]
  };
  var open = ({ assumed, chosen }) => assumed.filter((kind2) => !chosen?.[kind2]);
  var howRead = ({ assumed, chosen, read }) => [
    ...assumed.flatMap(
      (kind2) => chosen?.[kind2] ? tr("{letter} in {unit} (as chosen)", { letter: QUANTITY[kind2][0], unit: chosen[kind2] }) : []
    ),
    ...read.map(told)
  ];
  function heads(read) {
    const left = open(read);
    const named2 = (kind2, cart2 = "") => {
      const [letter, unit] = QUANTITY[kind2];
      const what = cart2 ? tr("{letter} of {cart}", { letter, cart: cart2 }) : letter;
      return left.some((one) => one === kind2) ? what : tr("{letter} in {unit}", { letter: what, unit });
    };
    return {
      time: named2("time"),
      value: named2(read.kind),
      tracks: read.names.map((name) => named2(read.kind, name))
    };
  }
  function semicolons([first = "", ...rest]) {
    return rest.reduce((before2, then) => tr("{first}; {then}", { first: before2, then }), first);
  }

  // ../view/measured/table.js
  var PLACES = 4;
  function tableOf2(read, residuals) {
    const { names, tracks } = read;
    const { time, tracks: its } = heads(read);
    const head = [time, ...its];
    if (residuals) head.push(...names.map((cart2) => tr("residual of {cart} in mm", { cart: cart2 })));
    const found = /* @__PURE__ */ new Map();
    for (const [k, track] of tracks.entries()) {
      for (const [n, t] of track.t.entries()) {
        const cells2 = found.get(t) ?? Array.from({ length: head.length - 1 }, () => "");
        cells2[k] = fixed(Number(track.value[n]), PLACES);
        if (residuals) cells2[2 + k] = fixed(1e3 * Number(residuals[k]?.[n]), 2);
        found.set(t, cells2);
      }
    }
    const rows = [...found].sort(([a], [b]) => a - b).map(([t, cells2]) => [fixed(t, PLACES), ...cells2]);
    return { head, rows };
  }

  // ../view/measured/skeleton.js
  var MOST_ROWS = 60;
  var UNITS3 = [
    ["length", () => tr("lengths are in")],
    ["time", () => tr("times are in")],
    ["force", () => tr("forces are in")]
  ];
  var HANDS = [
    ["touch", () => tr("first touch at"), "s"],
    ["va", () => tr("velocity of {cart} before", { cart: "A" }), "m/s"],
    ["vb", () => tr("velocity of {cart} before", { cart: "B" }), "m/s"],
    ["ratio", () => tr("mass of {b} ÷ mass of {a}", { a: "A", b: "B" }), ""],
    ["e", () => tr("bounciness e"), ""],
    ["duration", () => tr("the contact lasts"), "s"]
  ];
  var SIGNED = ["touch", "va", "vb"];
  var LAWS = { bumper: () => tr("bumper"), paper: () => tr("paper") };
  function inside4(facts) {
    const { id, title } = facts;
    const hint = html`<text class="carts-measured-hint" x="320" y="130" text-anchor="middle">${tr("Open a file or a film, drop it here, or type readings.")}</text>`;
    return html`<div class="carts-measured-frame" role="group" aria-labelledby="${id}-title">
<div class="carts-top"><p class="carts-title" id="${id}-title">${title}</p>${liveMark()}</div>
<div class="carts-note" role="status" hidden></div>
${source(facts)}
<div class="carts-measured-world" hidden><svg class="carts-measured-stage" viewBox="0 0 640 96" width="640" height="96" role="img" aria-label=${tr("the model’s carts; rings are the measured places")}></svg>
<div class="carts-transport carts-measured-transport"><button type="button" class="carts-button carts-play carts-measured-play">${tr("Play")}</button><input type="range" class="carts-measured-scrub" min="0" max="1" step="any" value="0" aria-label=${tr("time")}><span class="carts-measured-clock"></span></div></div>
<div class="carts-measured-figures">
<p class="carts-measured-legend"></p>
<div class="carts-measured-spans" hidden></div>
<svg class="carts-measured-figure" viewBox="0 0 640 284" width="640" height="284" role="img" aria-label=${tr("readings over time; the numbers are in the table below")}>${!facts.read && hint}</svg>
<svg class="carts-measured-left" viewBox="0 0 640 134" width="640" height="134" role="img" aria-label=${tr("residuals: measured minus model")} hidden></svg>
<p class="carts-measured-spread" role="status"></p>
</div>
${model(facts)}
<div class="carts-measured-result" hidden></div>
<div class="carts-measured-back" hidden>
<p class="carts-measured-row"><button type="button" class="carts-button carts-measured-scene">${tr("Save the fitted scene")}</button> <button type="button" class="carts-button carts-measured-tracker">${tr("Save the model’s run for Tracker")}</button> <button type="button" class="carts-button carts-measured-print">${tr("Print this alone")}</button></p>
<details class="carts-more"><summary>${tr("The fitted scene as a block of a lesson")}</summary><textarea class="carts-measured-fence" rows="10" readonly spellcheck="false" aria-label=${tr("block of a lesson")}></textarea></details>
</div>
${table3(facts)}
<noscript><p class="carts-noscript">${tr("The readings are shown. Fitting them here needs JavaScript; on the command line “carts fit” does the same.")}</p></noscript>
</div>`;
  }
  function source({ name, units, offered, read }) {
    const choices = UNITS3.map(([kind2, text3], k) => {
      const options = offered[kind2].map(
        (unit) => html`<option value=${unit}${units?.[kind2] === unit && html` selected`}>${unit}</option>`
      );
      const said = read && !read.assumed.some((one) => one === kind2) && html` hidden`;
      return html`${k > 0 && " "}<label${said}>${text3()} <select autocomplete="off" class="carts-measured-unit" data-kind=${kind2} disabled><option value="">${tr("choose …")}</option>${options}</select></label>`;
    });
    const own = html`<button type="button" class="carts-button carts-measured-own" disabled>${tr("The lesson’s readings")}</button> `;
    return html`<div class="carts-measured-source">
<p class="carts-measured-row"><button type="button" class="carts-button carts-measured-open" disabled>${tr("Open a file")}</button><input type="file" class="carts-measured-file" accept=".txt,.csv,.tsv,.trk,.trz,.zip,text/plain,text/csv,application/zip" multiple hidden tabindex="-1" aria-label=${tr("files with readings")}> ${film()}${name && own}<button type="button" class="carts-button carts-measured-save" disabled>${tr("Save these readings")}</button></p>
<details class="carts-more carts-measured-paste"><summary>${tr("Paste readings")}</summary><label>${tr("Text from Tracker, a spreadsheet or a sensor")} <textarea rows="6" spellcheck="false" autocomplete="off" disabled></textarea></label><p class="carts-measured-row"><button type="button" class="carts-button carts-measured-take" disabled>${tr("Read this text")}</button></p></details>
<details class="carts-more carts-measured-type"><summary>${tr("Type readings")}</summary><div class="carts-scroll" role="group" aria-label=${tr("table to type readings into")}><table class="carts-table carts-measured-grid"><thead><tr><th scope="col">t</th><th scope="col">${tr("{letter} of {cart}", { letter: "x", cart: "A" })}</th><th scope="col">${tr("{letter} of {cart}", { letter: "x", cart: "B" })}</th></tr></thead><tbody></tbody></table></div><p class="carts-measured-row"><button type="button" class="carts-button carts-measured-more" disabled>${tr("More rows")}</button> <button type="button" class="carts-button carts-measured-typed-take" disabled>${tr("Read this table")}</button></p></details>
<p class="carts-measured-row">${choices}</p>
<p class="carts-measured-row"><label class="carts-measured-runs" hidden>${tr("run")} <select autocomplete="off" class="carts-measured-run"></select></label> <label>${tr("use readings from")} <input type="text" autocomplete="off" class="carts-measured-from" disabled> s</label> <label>${tr("until")} <input type="text" autocomplete="off" class="carts-measured-until" disabled> s</label></p>
<p class="carts-measured-said" role="status">${name && `${name}: ${read ? semicolons(howRead(read)) : ""}`}</p>
<div role="alert"><ul class="carts-measured-faults carts-measured-unread"></ul></div>
</div>`;
  }
  function film() {
    return html`<button type="button" class="carts-button carts-measured-film" disabled>${tr("Choose a film")}</button><input type="file" class="carts-measured-film-file" accept="video/*,.mp4,.m4v,.mov,.webm" hidden tabindex="-1" aria-label=${tr("film of the carts")}> <button type="button" class="carts-button carts-measured-camera" hidden disabled>${tr("Film with the camera")}</button> `;
  }
  function model({ id, law }) {
    const hands = HANDS.map(
      ([key2, text3, unit]) => html`<div class="carts-measured-hand" data-hand=${key2}><label for="${id}-${key2}">${text3()}</label><input type="range" class="carts-measured-slide" aria-label=${text3()} disabled><span class="carts-measured-typed"><input type="text" id="${id}-${key2}" inputmode=${SIGNED.includes(key2) ? "text" : "decimal"} autocomplete="off" disabled> ${unit}</span></div>`
    );
    const laws = Object.entries(LAWS).map(
      ([name, text3]) => html`<option value=${name}${law === name && html` selected`}>${text3()}</option>`
    );
    return html`<div class="carts-measured-model" hidden>
<p class="carts-heading">${tr("Set the model by hand, or let it be fitted")}</p>
<div class="carts-measured-hands">${hands}</div>
<p class="carts-measured-row"><label>${tr("contact law")} <select autocomplete="off" class="carts-measured-law">${laws}</select></label> <label>${tr("fit also")} <select autocomplete="off" class="carts-measured-effect"><option value="none">${tr("nothing else")}</option><option value="friction">${tr("friction of each cart")}</option><option value="tilt">${tr("a tilt of the track")}</option><option value="both">${tr("friction and a tilt")}</option><option value="called">${tr("what the readings call for")}</option></select></label></p>
<p class="carts-measured-row carts-measured-masses carts-measured-rare"></p>
<p class="carts-measured-row carts-measured-rare"><label>${tr("marks are apart, when the bumpers just touch:")} <input type="text" inputmode="decimal" autocomplete="off" class="carts-measured-distance"> m</label> <span class="carts-quiet">${tr("if you know it")}</span></p>
<p class="carts-measured-row carts-measured-rare"><label><input type="checkbox" class="carts-measured-together"> ${tr("I saw that the carts stayed together")}</label> <span class="carts-quiet">${tr("where a sensor lost one of them")}</span></p>
<div role="alert"><ul class="carts-measured-faults carts-measured-unfitted"></ul></div>
<p class="carts-measured-row"><button type="button" class="carts-button carts-measured-fit">${tr("Fit the model")}</button> <button type="button" class="carts-button carts-measured-compare">${tr("Compare with friction and tilt")}</button> <span class="carts-measured-busy" role="status"></span></p>
</div>`;
  }
  function table3({ read }) {
    const { head, rows } = read ? tableOf2(read, null) : { head: [], rows: [] };
    const heads2 = head.map((cell2) => html`<th scope="col">${cell2}</th>`);
    const lines3 = rows.slice(0, MOST_ROWS).map((row2) => html`<tr>${row2.map((cell2) => html`<td>${cell2}</td>`)}</tr>`);
    const more = rows.length - lines3.length;
    return html`<details class="carts-more carts-measured-table"><summary>${tr("Table of the readings")}</summary><div class="carts-scroll" role="group" tabindex="0" aria-label=${tr("readings")}><table class="carts-table"><thead><tr>${heads2}</tr></thead><tbody>${lines3}</tbody></table></div>${more > 0 && html`<p class="carts-measured-rest">${counted("and 1 more row", "and {n} more rows", more)}</p>`}</details>`;
  }

  // ../effects/drag/view.js
  var view_default = {
    name: tr("air resistance"),
    row: 4,
    side: () => "above",
    agent: () => tr("the air"),
    around: tr("air"),
    warms: () => tr("air"),
    phrase({ numbers: { linear, quadratic } }, { everyone, on, seen }) {
      const sizes = [
        linear ? tr("{size} N per {unit}", { size: short(linear), unit: "m/s" }) : "",
        quadratic ? tr("{size} N per {unit}", { size: short(quadratic), unit: "(m/s)²" }) : ""
      ].filter(Boolean);
      return [
        everyone ? tr("drag by the air") : tr("drag on {carts} by the air", { carts: on }),
        seen(listed(sizes) || "0 N")
      ];
    }
  };

  // ../effects/friction/view.js
  var TOOTH = 4;
  var view_default2 = {
    name: tr("friction"),
    row: 3,
    side: () => "below",
    agent: () => tr("the track"),
    around: tr("track"),
    earth: true,
    warms: () => tr("track"),
    phrase({ numbers: { coefficient = 0, static: held = coefficient } }, { everyone, on, seen }) {
      const size = `μ = ${short(coefficient)}`;
      const rest = tr("(at rest up to {coefficient})", { coefficient: short(held) });
      return [
        everyone ? tr("friction by the track") : tr("friction on {carts} by the track", { carts: on }),
        seen(held > coefficient ? `${size} ${rest}` : size)
      ];
    },
    pieces: rough
  };
  function rough({ carts }, { key: key2, header: { bodies, track }, layout, face: face2, centre }) {
    const piece = { cls: "carts-rough", behind: true };
    if (carts.length < bodies.length) {
      return carts.map((name) => {
        const length = (bodies.find((body2) => body2.name === name)?.length ?? 0) * layout.scale;
        const d2 = teeth(centre(name) - length / 2, length, layout.track);
        return { ...piece, key: `${key2} ${name}`, d: d2 };
      });
    }
    const start = track.left === "wall" ? face2("left", "right") : -layout.width;
    const end2 = track.right === "wall" ? face2("right", "left") : 2 * layout.width;
    const tooth = 2 * TOOTH;
    const first = Math.max(start, -tooth + (start % tooth + tooth) % tooth);
    const d = teeth(first, Math.min(end2, layout.width) - first, layout.track);
    return [{ ...piece, key: key2, d }];
  }
  function teeth(x, length, y) {
    const count = Math.max(0, Math.floor(length / (2 * TOOTH)));
    return `M${px(x)} ${px(y)}${`l${px(TOOTH)} ${px(TOOTH)}l${px(TOOTH)} ${px(-TOOTH)}`.repeat(count)}`;
  }

  // ../effects/incline/view.js
  var STEEPEST = 22;
  var ROW = 24;
  var LENGTH = { wide: 120, narrow: 90 };
  var view_default3 = {
    name: tr("a slope"),
    row: 1,
    agent: () => tr("the Earth"),
    earth: true,
    stored: tr("as height, above the lowest point"),
    slope: ({ numbers }) => numbers.angle ?? 0,
    forceName: (on, by) => tr("part of the weight of {on}, along the track: force on {on} by {by}", { on, by }),
    label: (told3) => tr("on {on} by {by} (slope): {size} N", told3),
    phrase: ({ numbers }, { everyone, on }) => [
      everyone ? tr("a slope") : tr("a slope on {carts}", { carts: on }),
      slopeText(numbers.angle ?? 0)
    ],
    pieces({ index: index2, carts, numbers: { angle = 0 } }, { key: key2, header, layout }) {
      const slope = Math.abs(Math.tan(angle));
      const longest = LENGTH[layout.kind] ?? 0;
      const length = slope ? Math.min(longest, STEEPEST / slope) : longest;
      const inclines = header.effects.filter(({ kind: kind2 }) => kind2 === "incline");
      const place2 = inclines.findIndex((one) => one.index === index2);
      const [x, y, rise] = [12, layout.tilt + ROW * Math.max(0, place2), length * slope];
      const whose = carts.length < header.bodies.length ? `${listed(carts)}: ` : "";
      const [tall, flat] = angle > 0 ? [x, x + length] : [x + length, x];
      const d = `M${px(tall)} ${px(y)}V${px(y - rise)}L${px(flat)} ${px(y)}Z`;
      const words = {
        text: whose + tiltText(angle),
        x: px(x + length + 10),
        y: px(y),
        anchor: "start"
      };
      return [
        { key: key2, cls: "carts-wedge", behind: true, d },
        { key: `${key2} words`, cls: "carts-tilt", behind: true, ...words }
      ];
    }
  };
  function tiltText(angle) {
    if (!angle) return tr("the track is level: 0°");
    const words = tr("track tilted {slope}", { slope: slopeText(angle) });
    return angle > 0 ? `${words} →` : `← ${words}`;
  }
  function slopeText(angle) {
    const size = short(Math.abs(angle) * 180 / Math.PI);
    if (size === "0") return tr("0°: the track is level");
    return angle > 0 ? tr("{angle}° down to the right", { angle: size }) : tr("{angle}° down to the left", { angle: size });
  }

  // ../effects/magnets/view.js
  var POLE = 14;
  var POLES = [
    ["N", "carts-north"],
    ["S", "carts-south"]
    // only where there is room
  ];
  var view_default4 = {
    name: tr("magnets"),
    link: tr("magnets"),
    apart: true,
    stored: tr("between the magnets"),
    phrase: (_, { both }) => [tr("magnets on {bodies}, like poles facing", { bodies: both })],
    pieces({ between: between2 }, { key: key2, layout, face: face2 }) {
      const [a, b] = between2 ?? ["", ""];
      return [
        ...poles(`${key2} ${a}`, face2(a, "right"), -1, layout),
        ...poles(`${key2} ${b}`, face2(b, "left"), 1, layout)
      ];
    }
  };
  function poles(key2, x, direction, { kind: kind2, track }) {
    const top = track - 40;
    return POLES.slice(0, kind2 === "wide" ? 2 : 1).flatMap(([pole = "", cls = ""], k) => {
      const start = x + direction * k * POLE;
      const d = `M${px(start)} ${px(top)}h${px(direction * POLE)}v16h${px(-direction * POLE)}Z`;
      const letter = { text: pole, x: px(start + direction * POLE / 2), y: px(top + 13) };
      return [
        { key: `${key2} ${pole}`, cls, d },
        { key: `${key2} ${pole} letter`, cls: "carts-pole", anchor: "middle", ...letter }
      ];
    });
  }

  // ../view/shapes.js
  var REFERENCE_HEIGHT = 38;
  var TALLEST = 4;
  var LANE = 21;
  var ABOVE = 33;
  var DOT = 2.5;
  var RING = 1;
  var SHORTEST = 0.5;
  var LONGEST = 1.15;
  var FASTEST = 2.2;
  var EDGE2 = 5;
  var TORN2 = 6;
  var LINE = 14;
  var NAMED = 34;
  var LETTER = 9.5;
  var SPRING = [2, 10];
  var PUSH = 15.5;
  var FACE = 22;
  var WHEEL = 5.5;
  var LIFT = -3;
  var TURNS = 9;
  var LEAD = 5;
  var COIL = 7;
  function box(body2, view, layout, i, skin) {
    const lift = layout.stagger * (i % layout.ranks);
    const width = bodyWidth(body2);
    const wanted = REFERENCE_HEIGHT * (view.alike ? 1 : body2.mass / width / view.perHeight);
    const cut = wanted > TALLEST * REFERENCE_HEIGHT * (1 + 1e-9);
    const height = Math.min(wanted, TALLEST * REFERENCE_HEIGHT);
    const word = isWord(body2.name) ? body2.name.length * LETTER : 0;
    const named2 = height >= NAMED && (!word || !skin && word < width * layout.scale);
    const mass = `${short(body2.mass)} kg`;
    return {
      x: -width * layout.scale / 2,
      width: width * layout.scale,
      height,
      cut,
      nameY: named2 ? -(height + FACE) / 2 + 5 : null,
      label: named2 ? mass : `${body2.name}: ${mass}`,
      labelY: named2 ? -height - 5 - lift : -Math.max(height, FACE) - 5 - lift
    };
  }
  function wheels({ width }) {
    const x = px(Math.max(width / 3, width / 2 - 1.5 * WHEEL));
    return `M-${x} ${LIFT}h0M${x} ${LIFT}h0`;
  }
  function bodyWidth(body2) {
    return Math.max(body2.length - 2 * body2.bumper_length, 0.2 * body2.length);
  }
  function lane(i, tallest, layout) {
    const above = Math.max(tallest, FACE) + layout.stagger * (layout.ranks - 1) + ABOVE;
    return layout.track - above - LANE * (layout.lanes - 1 - i % layout.lanes);
  }
  function spring(start, end2) {
    const low = SPRING[0];
    const high = SPRING[1];
    const step = (end2 - start) / 4;
    let d = `M${px(start)} ${px(-(low + high) / 2)}`;
    for (let k = 0; k < 4; k += 1) {
      d += `L${px(start + (k + 0.5) * step)} ${px(k % 2 === 0 ? -high : -low)}`;
    }
    return `${d}L${px(end2)} ${px(-(low + high) / 2)}`;
  }
  function coil(start, end2, y, turns = TURNS, high = COIL) {
    const span2 = Math.max(0, end2 - start);
    const lead = Math.min(LEAD, span2 / 4);
    const step = (span2 - 2 * lead) / turns;
    let d = `M${px(start)} ${px(y)}L${px(start + lead)} ${px(y)}`;
    for (let k = 0; k < turns; k += 1) {
      d += `L${px(start + lead + (k + 0.5) * step)} ${px(k % 2 === 0 ? y - high : y + high)}`;
    }
    return `${d}L${px(start + span2 - lead)} ${px(y)}L${px(start + span2)} ${px(y)}`;
  }
  function blockArrow(x, y, length) {
    if (Math.abs(length) < SHORTEST) return dot(x, y);
    const tip = x + length;
    const neck = tip - Math.sign(length) * Math.min(9, Math.abs(length));
    return `M${px(x)} ${px(y - 3)}L${px(neck)} ${px(y - 3)}L${px(neck)} ${px(y - 6.5)}L${px(tip)} ${px(y)}L${px(neck)} ${px(y + 6.5)}L${px(neck)} ${px(y + 3)}L${px(x)} ${px(y + 3)}Z`;
  }
  function cutArrow(x, y, length) {
    const half = length / 2 - Math.sign(length) * TORN2 / 2;
    const piece = `M${px(x)} ${px(y - 3)}h${px(half)}v6h${px(-half)}Z`;
    return piece + blockArrow(x + length - half, y, half);
  }
  function lineArrow(x, y, length) {
    if (Math.abs(length) < SHORTEST) return dot(x, y, RING);
    const tip = x + length;
    const back = tip - Math.sign(length) * Math.min(7, Math.abs(length));
    return `M${px(x)} ${px(y)}L${px(tip)} ${px(y)}M${px(back)} ${px(y - 4.5)}L${px(tip)} ${px(y)}L${px(back)} ${px(y + 4.5)}`;
  }
  function dot(x, y, radius = DOT) {
    const [r, d] = [px(radius), px(2 * radius)];
    return `M${px(x - radius)} ${px(y)}a${r} ${r} 0 1 0 ${d} 0a${r} ${r} 0 1 0 -${d} 0Z`;
  }
  function arrowLength(value, full, length, longest = LONGEST) {
    const exact = full ? value / full * length : 0;
    return Math.max(-longest * length, Math.min(longest * length, exact));
  }
  function isCut(value, full, longest = LONGEST) {
    return full > 0 && Math.abs(value) > longest * full;
  }
  function velocityText(x, length, width) {
    const room = 72;
    if (length >= 0) return x > room ? [x - 8, "end"] : [x + length + 8, "start"];
    return x < width - room ? [x + 8, "start"] : [x + length - 8, "end"];
  }
  function keptInside(x, length, width) {
    if (x > EDGE2 && x < width - EDGE2) {
      if (x + length > width - EDGE2) return width - EDGE2 - x;
      if (x + length < EDGE2) return EDGE2 - x;
    }
    return length;
  }
  function labelTop(box2) {
    return box2.labelY - LINE;
  }

  // ../view/trajectory.js
  function fromBaked(numbers, events) {
    const parts2 = { t: Float64Array.from(numbers.t), events };
    for (const quantity of ["x", "v", "a", "F", "dF", "E"]) {
      parts2[quantity] = {};
      for (const [key2, column] of Object.entries(numbers[quantity] ?? {})) {
        parts2[quantity][key2] = Float64Array.from(column);
      }
    }
    return parts2;
  }
  function isTold({ trajectory }) {
    return trajectory.t.length > 1;
  }
  function rowAt(times2, t) {
    let low = 0;
    let high = times2.length;
    while (low < high) {
      const middle = low + high >> 1;
      if (times2[middle] <= t) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }
  function valueAt2(times2, values, slopes, t) {
    const k = rowAt(times2, t);
    if (k < 0) return Number(values[0]);
    if (k >= times2.length - 1) return Number(values[values.length - 1]);
    return hermite(times2, values, slopes, k, t);
  }
  function hermite(times2, values, slopes, k, t) {
    const at = ((c, i) => c[i]);
    const h = at(times2, k + 1) - at(times2, k);
    const s = (t - at(times2, k)) / h;
    if (!slopes) return at(values, k) + (at(values, k + 1) - at(values, k)) * s;
    const r = 1 - s;
    const found = at(values, k) * (1 + 2 * s) * r * r + at(slopes, k) * h * s * r * r + at(values, k + 1) * (1 + 2 * r) * s * s - at(slopes, k + 1) * h * r * s * s;
    return Number.isFinite(found) ? found : at(values, k);
  }
  function turnAfter(times2, values, slopes, k) {
    const [before2, after2] = [Number(slopes?.[k]), Number(slopes?.[k + 1])];
    const [begin, span2] = [Number(times2[k]), Number(times2[k + 1]) - Number(times2[k])];
    if (!slopes || !(before2 * after2 < 0) || !(span2 > 0)) return null;
    return hermite(times2, values, slopes, k, begin + span2 * before2 / (before2 - after2));
  }

  // ../effects/push/view.js
  var LET_GO = 1.5;
  var BACK = 0.2;
  var ROOM = 16;
  var MIDDLE = 29;
  var HAND = "M-46 -6L-31 -7C-26 -9 -22 -6 -17 -3.5L-3 -3.5C1 -3.5 1 3 -3 3L-15 3C-10 3 -10 7.5 -15 7.5C-11 7.5 -11 12 -16 12C-13 12 -13 16 -18 16C-26 17 -29 14 -32 9L-46 9M-15 3h-7M-15 7.5h-6M-16 12h-5M-29 0C-24 0 -21 -1 -19 3M-38 -9h-8v20h8Z";
  var view_default5 = {
    name: tr("pushes from outside"),
    row: 2,
    side: (force) => force < 0 ? "right" : "left",
    around: (_, agent2) => agent2,
    acts: ({ numbers: { from = 0, until = Infinity } }, t) => t >= from && t < until,
    seen: (effect, t) => begun(effect, t) && t < end(effect) + (isHand(effect) ? LET_GO : 0),
    phrase: (effect, { agent: agent2, seen }) => [
      tr("a push on {cart} by {agent}", { cart: String(effect.carts[0]), agent: agent2 }),
      seen(forceText(effect.numbers.force ?? 0)),
      times(effect)
    ],
    pieces(effect, { key: key2, header, run, t, layout, centre }) {
      const { carts, numbers } = effect;
      const name = String(carts[0]);
      const y = layout.track;
      const direction = (numbers.force ?? 0) >= 0 ? 1 : -1;
      const body2 = header.bodies.find((one) => one.name === name);
      const side2 = centre(name) - direction * ((body2 ? bodyWidth(body2) * layout.scale : 0) / 2);
      if (isHand(effect)) {
        const past = t - end(effect);
        if (past >= 0 && goesOn(effect, header)) return [];
        const gone = past < 0 ? 0 : direction * ROOM * Math.min(1, past / BACK);
        const left = past < 0 ? side2 : side2 - (place(run, name, t) - place(run, name, end(effect))) * layout.scale;
        return [{ key: key2, cls: "carts-hand carts-palm", d: hand(left - gone, y - MIDDLE, direction) }];
      }
      const x = side2 - 3 * direction;
      const d = `M${px(x)} ${px(y - 38)}v14M${px(x)} ${px(y - 31)}h${px(-direction * 26)}`;
      return [{ key: key2, cls: "carts-hand", behind: true, d }];
    },
    marks({ carts, numbers: { from = 0, until: end2, force = 0 } }, agent2, until, told3) {
      const who = { cart: String(carts[0]), agent: agent2 };
      const begins = told3 ? tr("The push on {cart} by {agent} begins: {force}.", { ...who, force: forceText(force) }) : tr("The push on {cart} by {agent} begins.", who);
      const marks3 = from <= until ? [{ t: from, sentence: begins }] : [];
      if (end2 !== void 0 && from < end2 && end2 <= until) {
        marks3.push({ t: end2, sentence: tr("The push on {cart} by {agent} ends.", who) });
      }
      return marks3;
    }
  };
  var isHand = ({ by }) => !by || by === "hand";
  var begun = ({ numbers: { from = 0 } }, t) => t >= from;
  var end = ({ numbers: { until = Infinity } }) => until;
  function goesOn(effect, { effects }) {
    const on = (one) => one.active && one.kind === effect.kind && one.carts[0] === effect.carts[0] && isHand(one);
    return effects.some((one) => on(one) && one !== effect && (one.numbers.from ?? 0) >= end(effect));
  }
  function place({ trajectory: { t: times2, x, v } }, name, t) {
    return valueAt2(times2, x[name] ?? [], v[name] ?? [], t);
  }
  function hand(x, y, direction) {
    let across3 = true;
    let absolute = true;
    return HAND.replace(/[MLCvhZ]|-?[\d.]+/g, (part) => {
      if (/[a-zA-Z]/.test(part)) {
        across3 = part !== "v";
        absolute = part === part.toUpperCase();
        return part;
      }
      const number = Number(part);
      const shown2 = across3 ? direction * number + (absolute ? x : 0) : number + (absolute ? y : 0);
      across3 = absolute ? !across3 : across3;
      return ` ${px(shown2)}`;
    });
  }
  function forceText(force) {
    const size = short(Math.abs(force));
    return force >= 0 ? tr("{size} N to the right", { size }) : tr("{size} N to the left", { size });
  }
  function times({ numbers: { from = 0, until } }) {
    if (until !== void 0) {
      return tr("from {from} s to {until} s", { from: short(from), until: short(until) });
    }
    return from ? tr("from {from} s", { from: short(from) }) : "";
  }

  // ../effects/release/view.js
  var HALF = 9;
  var TURNS2 = 7;
  var HIGH = 4;
  var ABOVE2 = 28;
  var view_default6 = {
    name: tr("a release between the carts"),
    leftOut: tr("springs that are let go"),
    link: tr("spring"),
    lasts: ({ numbers }) => numbers.stiffness !== void 0,
    // else an impulse: no force to be drawn
    stored: tr("in the squeezed spring"),
    acts: ({ numbers: { at = 0, stiffness } }, t) => t < at || stiffness !== void 0,
    phrase: ({ numbers: { energy = 0, at = 0, stiffness } }, { both, seen }) => [
      stiffness === void 0 ? tr("an exploder between {bodies}", { bodies: both }) : tr("a squeezed spring between {bodies} that is let go", { bodies: both }),
      seen(`${short(energy)} J`),
      stiffness === void 0 ? "" : seen(`${short(stiffness)} N/m`),
      tr("at {time} s", { time: short(at) })
    ],
    pieces(effect, { key: key2, run, t, layout, face: face2 }) {
      const [a, b] = effect.between ?? ["", ""];
      const [begun2, ended2] = pushes(effect, run);
      const low = layout.track - ABOVE2;
      const ends2 = [face2(a, "right"), face2(b, "left")].map(Number);
      if (t > ended2) {
        const there = edge2(run, a, ended2) - edge2(run, a, t);
        const start2 = Number(ends2[0]) + there * layout.scale - HALF;
        const long = (edge2(run, b, ended2, -1) - edge2(run, a, ended2)) * layout.scale;
        const lying = coil(start2, start2 + long + 2 * HALF, layout.track - HIGH, TURNS2, HIGH);
        return [{ key: `${key2} lying`, cls: "carts-coil carts-spent", behind: true, d: lying }];
      }
      const middle = (Number(ends2[0]) + Number(ends2[1])) / 2;
      const [start = 0, end2 = 0] = t < begun2 ? [middle, middle] : ends2;
      const wire = coil(start - HALF, end2 + HALF, low, TURNS2, HIGH);
      const plates = t < begun2 ? `M${px(start - HALF - 1)} ${px(low + 7)}v-15h20v15` : `M${px(start - HALF - 1)} ${px(low + 7)}v-14M${px(end2 + HALF + 1)} ${px(low + 7)}v-14`;
      return [
        { key: key2, cls: "carts-coil", d: wire },
        { key: `${key2} latch`, cls: "carts-latch", d: plates }
      ];
    }
  };
  function pushes({ between: between2, numbers: { at = 0 } }, { header, trajectory }) {
    const pair = between2?.join("-");
    const mine = header.events.filter(({ bodies }) => bodies.join("-") === pair);
    const begun2 = mine.find(({ kind: kind2, t }) => kind2 === "release" && t === at);
    if (!begun2 || trajectory.t.length < 2) return [Infinity, Infinity];
    const ended2 = mine.find(({ kind: kind2, t }) => kind2 === "separate" && t > begun2.t);
    return [begun2.t, ended2?.t ?? Infinity];
  }
  function edge2({ header, trajectory }, name, t, direction = 1) {
    const half = (header.bodies.find((body2) => body2.name === name)?.length ?? 0) / 2;
    return valueAt2(trajectory.t, trajectory.x[name] ?? [], trajectory.v[name] ?? [], t) + direction * half;
  }

  // ../effects/spring/view.js
  var view_default7 = {
    name: tr("springs between the carts"),
    link: tr("spring"),
    stored: tr("in the spring"),
    warms: ({ numbers }) => (numbers.damping ?? 0) > 0 ? tr("spring") : "",
    phrase({ numbers: { stiffness = 0, length = 0, damping } }, { both, seen }) {
      const natural = tr("natural length {length} m", { length: short(length) });
      return [
        tr("a spring between {bodies}", { bodies: both }),
        damping ? tr("damped") : "",
        seen(`${short(stiffness)} N/m, ${natural}`)
      ];
    },
    pieces({ numbers, between: between2 }, { key: key2, layout, face: face2 }) {
      const [a, b] = between2 ?? ["", ""];
      const [start, end2] = [face2(a, "right"), face2(b, "left")];
      const length = (numbers.length ?? 0) * layout.scale;
      const middle = (start + end2) / 2;
      const low = a === "left" ? start : b === "right" ? end2 - length : middle - length / 2;
      const y = layout.track - PUSH - COIL - 5;
      const measure2 = `M${px(low)} ${px(y - 3)}v6M${px(low)} ${px(y)}h${px(length)}m0 -3v6`;
      return [
        { key: key2, cls: "carts-coil", d: coil(start, end2, layout.track - PUSH) },
        { key: `${key2} natural`, cls: "carts-natural", d: measure2 }
      ];
    }
  };

  // ../effects/views.js
  var VIEWS = {
    drag: view_default,
    friction: view_default2,
    incline: view_default3,
    magnets: view_default4,
    push: view_default5,
    release: view_default6,
    spring: view_default7
  };

  // ../view/effects.js
  var LAST = 100;
  function viewOf(kind2) {
    return { name: kind2, row: LAST, ...VIEWS[kind2] };
  }
  function nameOf({ kind: kind2, called }) {
    const name = VIEWS[kind2]?.name ?? (called && told(called));
    if (!name) throw new Error(`nobody describes an effect of the kind “${kind2}”`);
    return name;
  }
  function agent(effect) {
    const named2 = effect.by || effect.agent;
    return viewOf(effect.kind).agent?.(effect) ?? (named2 ? told(named2) : nameOf(effect));
  }
  function actsAt(effect, t) {
    return effect.active && (viewOf(effect.kind).acts?.(effect, t) ?? true);
  }
  function kindsOnOne({ effects }) {
    const kinds = new Set(effects.filter(({ between: between2 }) => !between2).map(({ kind: kind2 }) => kind2));
    return [...kinds].sort((a, b) => viewOf(a).row - viewOf(b).row || (a < b ? -1 : 1));
  }
  function isLink(effect) {
    const { link, lasts } = viewOf(effect.kind);
    return effect.between !== null && link !== null && (lasts?.(effect) ?? true);
  }
  function linkedPairs({ effects }) {
    return new Set(effects.filter(isLink).map(({ between: between2 }) => String(between2?.join("-"))));
  }
  function pairsApart({ effects }) {
    return effects.flatMap(
      ({ kind: kind2, active, between: between2 }) => active && between2 && viewOf(kind2).apart ? [between2] : []
    );
  }
  function linkOf({ effects }, pair) {
    const link = effects.find(
      (effect) => effect.active && isLink(effect) && effect.between?.join("-") === pair
    );
    return link ? viewOf(link.kind).link ?? viewOf(link.kind).name : "";
  }
  function effectOf(target, { effects }) {
    const owner = target.slice(0, target.lastIndexOf("."));
    return effects.find(
      ({ kind: kind2, index: index2 }) => [kind2, `effects.${index2}`, `effects.${index2}.${kind2}`].includes(owner)
    );
  }

  // ../view/words.js
  var QUANTITIES = {
    x: [tr("Position"), "x", "m"],
    v: [tr("Velocity"), "v", "m/s"],
    a: [tr("Acceleration"), "a", "m/s²"],
    F: [tr("Contact force"), "F", "N"],
    R: [tr("Resultant force"), "R", "N"],
    p: [tr("Momentum"), "p", "kg m/s"],
    energy: [tr("Kinetic energy"), "E", "J"]
  };
  var APART = "apart";
  var IMPULSE_ONLY = tr("too large and too short to draw: see the impulses under “What happens”");
  var JUMP_ONLY = tr("where v jumps, the acceleration is too large and too short to draw");
  function motion(velocity2, decimals, scale) {
    if (isRest(velocity2, scale)) return tr("at rest");
    const [per, unit] = speedUnit(scale);
    const speed = `${fixed(Math.abs(velocity2) / per, decimals)} ${unit}`;
    return velocity2 > 0 ? tr("{speed} to the right", { speed }) : tr("{speed} to the left", { speed });
  }
  function lawsOf(header) {
    const laws = Object.fromEntries(header.contacts.map(({ pair, law }) => [pair, law]));
    for (const bodies of pairsApart(header)) laws[bodies.join("-")] = APART;
    return laws;
  }
  function bareOf({ bodies, contacts }) {
    const sprung = bodies.filter((one) => one.bumper_length > 0).map(({ name }) => name);
    const bare = contacts.filter((contact) => !contact.bodies.some((name) => sprung.includes(name)));
    return new Set(bare.map(({ pair }) => pair));
  }
  function isRest(velocity2, scale) {
    return Math.abs(velocity2) < NOISE * scale;
  }
  function eventSentence(event, telling, laws, bare, track) {
    const { decimals, scale, camera, forces: forces2 } = telling;
    const names = event.bodies;
    const pair = capital(bodiesOf(names, track));
    const impulse = event.impulse ?? 0;
    const speeds = names.filter((name) => !isWall(name) && name in (event.after ?? {})).map((name) => `${name}: ${motion((event.after[name] ?? 0) - camera, decimals.v ?? 2, scale)}`);
    const after2 = speeds.map(ended).join(" ");
    const size = `${figures(impulse)} N s`;
    const shown2 = forces2 && impulse ? tr("Impulse on each: {size}.", { size }) : "";
    const told3 = (...sentences) => sentences.filter(Boolean).join(" ");
    switch (event.kind) {
      case "contact": {
        if (impulse && laws[names.join("-")] === "velcro") {
          return told3(tr("{pair} hit and stay together.", { pair }), shown2, after2);
        }
        if (impulse && joined2(event, scale)) return told3(...hitAndGoOn(event, telling, pair), shown2);
        if (impulse) {
          return told3(tr("{pair} hit each other and part at once.", { pair }), shown2, after2);
        }
        const [mover, other] = names[0] === "left" ? [names[1], names[0]] : [names[0], names[1]];
        return tr("{mover} touches {other}.", {
          mover: String(mover),
          other: body(String(other), track)
        });
      }
      case "peak":
        return peakSentence(event, telling, laws, bare, pair);
      case "separate": {
        if (!joined2(event, scale)) return told3(tr("{pair} separate.", { pair }), shown2, after2);
        const ended2 = { pair: bodiesOf(names, track) };
        const rest = isWall(String(names[0])) || isWall(String(names.at(-1)));
        if (rest) {
          const stay = tr("The push between {pair} has ended; they stay together.", ended2);
          return told3(stay, shown2, after2);
        }
        return told3(pushEnded(event, telling, ended2.pair), shown2);
      }
      case "stick":
        return told3(tr("{pair} stay together.", { pair }), after2);
      case "stop":
        return names[1] ? tr("{pair} stop: the track holds them.", { pair }) : tr("{cart} stops: the track holds it.", { cart: pair });
      case "start":
        return names[1] ? tr("{pair} start to move.", { pair }) : tr("{cart} starts to move.", { cart: pair });
      case "release":
        if (impulse || !event.force) {
          return told3(tr("The exploder between {pair} releases.", { pair }), shown2, after2);
        }
        return forces2 ? tr("The spring between {pair} is let go: {force} on each.", {
          pair,
          force: `${fixed(event.force, decimals.F ?? 2)} N`
        }) : tr("The spring between {pair} is let go.", { pair });
      case "end":
        return tr("End of the run.");
      default:
        return `${event.kind}: ${pair}.`;
    }
  }
  function peakSentence({ bodies, force: greatest3 }, { decimals, forces: forces2 }, laws, bare, pair) {
    const key2 = bodies.join("-");
    const force = `${fixed(greatest3 ?? 0, decimals.F ?? 2)} N`;
    if (laws[key2] === APART) {
      return forces2 ? tr("{pair} are nearest: {force} on each.", { pair, force }) : tr("{pair} are nearest.", { pair });
    }
    const told3 = forces2 && greatest3;
    if (laws[key2] !== "bumper") {
      return told3 ? tr("{pair} push hardest: {force} on each.", { pair, force }) : tr("{pair} push hardest.", { pair });
    }
    if (told3) {
      return bare.has(key2) ? tr("{pair}: squeezed the most, {force} on each.", { pair, force }) : tr("{pair}: bumpers squeezed the most, {force} on each.", { pair, force });
    }
    return bare.has(key2) ? tr("{pair}: squeezed the most.", { pair }) : tr("{pair}: bumpers squeezed the most.", { pair });
  }
  function joined2({ bodies, after: after2 }, scale) {
    const [left, right] = bodies.map((name) => isWall(name) ? 0 : Number(after2[name]));
    return isRest(Number(left) - Number(right), scale);
  }
  function hitAndGoOn(event, telling, pair) {
    const how = together(event, telling);
    return how === null ? [tr("{pair} hit and stay together, at rest.", { pair })] : [tr("{pair} hit and go on together at {velocity}.", { pair, velocity: how })];
  }
  function pushEnded(event, telling, pair) {
    const how = together(event, telling);
    return how === null ? tr("The push between {pair} has ended; they stay together, at rest.", { pair }) : tr("The push between {pair} has ended; they go on together at {velocity}.", {
      pair,
      velocity: how
    });
  }
  function together({ bodies, after: after2 }, { decimals, scale, camera }) {
    const cart2 = bodies.find((name) => !isWall(name)) ?? "";
    const seen = Number(after2[cart2]) - camera;
    return isRest(seen, scale) ? null : motion(seen, decimals.v ?? 2, scale);
  }
  function exitSentence({ name, side: side2, velocity: velocity2 }, decimals, scale) {
    const [per, unit] = speedUnit(scale);
    const speed = `${fixed(Math.abs(velocity2) / per, decimals)} ${unit}`;
    return side2 === "right" ? tr("{name} leaves the picture on the right, still {speed}.", { name, speed }) : tr("{name} leaves the picture on the left, still {speed}.", { name, speed });
  }
  function graphNote(quantity, events, curves) {
    const struck = events.some((event) => event.kind === "contact" && event.impulse);
    if (struck && quantity === "F") return IMPULSE_ONLY;
    if (struck && (quantity === "a" || quantity === "R")) return JUMP_ONLY;
    return quantity === "F" && !curves ? tr("no contact force in this run") : "";
  }
  function lower(name) {
    return name.slice(0, 1).toLowerCase() + name.slice(1);
  }
  function capital(text3) {
    return text3.slice(0, 1).toUpperCase() + text3.slice(1);
  }

  // ../view/effects-forces.js
  var FEW2 = 3;
  function forcesAt({ header, trajectory }, t, always = false) {
    const found = [];
    for (const kind2 of kindsOnOne(header)) {
      const acting = header.effects.filter(
        (effect) => effect.kind === kind2 && (always ? effect.active : actsAt(effect, t))
      );
      for (const { name } of header.bodies) {
        const own = acting.filter((effect) => effect.carts.includes(name));
        const column = trajectory.E[`${kind2} ${name}`];
        if (!own.length || !column?.length) continue;
        const peak = greatest(column);
        const on = own.some((effect) => actsAt(effect, t));
        const exact = on ? valueAt2(trajectory.t, column, null, t) : 0;
        const value = Math.abs(exact) <= NOISE * peak ? 0 : exact;
        const size = value ? fixed(Math.abs(value), decimalsFor(peak || 1)) : "0";
        found.push({ kind: kind2, on: name, by: listed([...new Set(own.map(agent))]), value, size });
      }
    }
    return found;
  }
  function partsOf(header, run, name) {
    return kindsOnOne(header).flatMap((kind2) => {
      const own = header.effects.filter(
        (effect) => effect.kind === kind2 && effect.active && effect.carts.includes(name)
      );
      const column = run.E[`${kind2} ${name}`];
      return own.length && column?.length ? [{ by: listed([...new Set(own.map(agent))]), column }] : [];
    });
  }
  function labels({ kind: kind2, on, by, size }) {
    const told3 = { on, by, size };
    const brief2 = { ...told3, by: by.replaceAll("the ", "") };
    return [
      viewOf(kind2).label?.(told3) ?? tr("on {on} by {by}: {size} N", told3),
      tr("on {on} by {by}: {size} N", brief2),
      tr("by {by}: {size} N", brief2)
      // whose force it is tells the line from the cart
    ];
  }
  function outside(header) {
    const { effects, track } = header;
    const sides = ["left", "right"];
    const walls = sides.filter((side2) => track[side2] === "wall").map((side2) => kind(side2, track));
    const kinds = kindsOnOne(header).map(viewOf);
    const media = kinds.map(({ around }) => typeof around === "string" ? around : "");
    const others = effects.map((effect) => {
      const { around } = viewOf(effect.kind);
      return typeof around === "function" ? around(effect, agent(effect)) : "";
    });
    const earth = walls.length || kinds.some((view) => view.earth) ? tr("Earth") : "";
    const parts2 = [...walls, ...media, ...others, earth];
    return [...new Set(parts2.filter(Boolean))].join(" + ");
  }
  var known = /* @__PURE__ */ new WeakMap();
  function greatest(column) {
    const before2 = known.get(column);
    if (before2 !== void 0) return before2;
    let most = 0;
    for (let k = 0; k < column.length; k += 1) most = Math.max(most, Math.abs(Number(column[k])));
    known.set(column, most);
    return most;
  }

  // ../view/forces.js
  function contactForce({ trajectory }, pair, t, zero) {
    const column = trajectory.F[pair];
    if (!column) return 0;
    const force = valueAt2(trajectory.t, column, trajectory.dF[pair] ?? null, t);
    return Math.abs(force) < zero ? 0 : force;
  }
  function resultant(run, name, t, zero) {
    return summed(forcesAlong(run, name, t, zero));
  }
  var summed = (along) => along.reduce((sum, { value }) => sum + value, 0);
  function forcesAlong(run, name, t, zero) {
    return [...contactForces(run, name, t, zero), ...effectForces(run, name, t)];
  }
  function contactForces(run, name, t, zero) {
    return run.header.contacts.filter(({ bodies }) => bodies.includes(name)).map((contact) => ({ ...contact, size: contactForce(run, contact.pair, t, zero) })).filter(({ pair, stiffness, size }) => size || stiffness || linkOf(run.header, pair)).map(({ bodies: [left, right], size }) => {
      const isLeft = left === name;
      const by = isLeft ? right : left;
      return {
        name: forceOn(body(name, run.header.track), body(by, run.header.track)),
        on: name,
        by,
        way: "along",
        side: isLeft ? "right" : "left",
        value: isLeft ? -size : size
      };
    }).sort((a, b) => a.side < b.side ? -1 : 1);
  }
  function effectForces(run, name, t) {
    return forcesAt(run, t, true).filter(({ on }) => on === name).map(({ kind: kind2, on, by, value, size }) => {
      const { forceName: forceName2 = forceOn, side: side2 } = viewOf(kind2);
      const at = side2?.(value) ?? "middle";
      return { name: forceName2(on, by), on, by, way: "along", side: at, value, size };
    });
  }
  function verticalNote(header) {
    return header.bodies.some(({ name }) => slopeOf(header, name)) ? tr(
      "On a slope the support balances only the part of the weight across the track; the rest of the weight acts along it. Weight and support are no third-law pair: the partner of the weight pulls on the Earth."
    ) : tr(
      "Weight and support are equal and opposite here, but both act on one cart: they balance. They are no third-law pair: the partner of the weight pulls on the Earth."
    );
  }
  function slopeOf({ effects }, name) {
    return effects.filter(({ active, carts }) => active && carts.includes(name)).reduce((sum, effect) => sum + (viewOf(effect.kind).slope?.(effect) ?? 0), 0);
  }
  function verticalForces({ header }, name) {
    const mass = header.bodies.find((one) => one.name === name)?.mass ?? 0;
    const slope = slopeOf(header, name);
    const weight = mass * header.gravity * Math.cos(slope);
    return [
      {
        name: slope ? tr("part of the weight of {name}, across the track: force on {name} by the Earth", {
          name
        }) : tr("weight of {name}: force on {name} by the Earth", { name }),
        by: "Earth",
        value: -weight
      },
      {
        name: tr("support: force on {name} by the track", { name }),
        by: "track",
        value: weight
      }
    ].map((force) => ({ ...force, on: name, way: "up", side: "middle" }));
  }

  // ../view/markers.js
  var MARKERS = {
    b0: "M-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0Z",
    b1: "M-3.5 -3.5H3.5V3.5H-3.5Z",
    b2: "M0 -5L5 0L0 5L-5 0Z",
    b3: "M-4.5 3.5L0 -4.5L4.5 3.5Z",
    b4: "M-4.5 -3.5L0 4.5L4.5 -3.5Z",
    b5: "M-4 -1.5H-1.5V-4H1.5V-1.5H4V1.5H1.5V4H-1.5V1.5H-4Z",
    b6: "M-4.5 -2.5H4.5V2.5H-4.5Z",
    b7: "M-2.5 -4.5H2.5V4.5H-2.5Z",
    wall: "M-3 -3L3 3M-3 3L3 -3",
    total: "M-2.5 0a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0 -5 0Z"
  };
  function styleOf(index2) {
    return `b${index2 % 8}`;
  }

  // ../view/skeleton/beside.js
  function near(baked) {
    return showsForces(baked) && frame(baked, "carts-views carts-near", lens(baked));
  }
  function views(baked) {
    const forces2 = showsForces(baked) && freeBody(baked);
    return frame(
      baked,
      "carts-views",
      html`${forces2}
${bars(baked)}`
    );
  }
  function showsForces({ fence, run }) {
    const linked = linkedPairs(run.header);
    const touches2 = run.header.contacts.some(({ stiffness, pair }) => stiffness || linked.has(pair));
    return fence.forces === "shown" && touches2;
  }
  function frame({ fence }, kinds, inside7) {
    return html`<div class=${kinds}${fence.predict && html` hidden`}>
${inside7}
</div>`;
  }
  var closed = ({ fence }, view) => !fence.opened.includes(view) && html` hidden`;
  function freeBody(baked) {
    const { bodies } = baked.run.header;
    const rows = [
      [tr("resultant force"), "R", "N", "F"],
      [tr("mass"), "m", "kg", "mass"],
      [tr("acceleration"), "a = R/m", "m/s²", "a"],
      [tr("change of velocity"), "Δv", speedUnit(baked.view.velocity)[1], "dv"]
    ];
    const alone = bodies.map(
      ({ name }, i) => html`<div class="carts-alone carts-${styleOf(i)}" data-body=${name}><svg viewBox="0 0 260 60" width="260" height="60" aria-hidden="true"><rect class="carts-box" x="20" y="8" width="220" height="44" rx="4"/><text class="carts-name" x="130" y="24">${name}</text><g data-part="forces"></g></svg><ul></ul></div>
`
    );
    const lines3 = rows.map(
      ([name, symbol, unit, quantity]) => html`<tr><th scope="row">${name} <i>${symbol}</i>${quantity === "dv" && html` <span class="carts-touch-note"></span>`}, ${unit}</th>${bodies.map((body2) => html`<td data-body=${body2.name} data-quantity=${quantity}>–</td>`)}</tr>
`
    );
    return html`<section class="carts-view carts-free-body" data-view="free-body"${closed(baked, "free-body")}>
<p class="carts-view-title"><span class="carts-heading">${tr("Forces on each cart")}</span> <label><input type="checkbox" class="carts-vertical"> ${tr("weight and support")}</label></p>
<div class="carts-bodies">
${alone}</div>
<p class="carts-vertical-note">${verticalNote(baked.run.header)}</p>
<div class="carts-scroll"><table class="carts-table carts-pairs"><thead><tr><th scope="col"><span class="carts-hidden">${tr("quantity")}</span></th>${bodies.map(({ name }) => html`<th scope="col">${name}</th>`)}</tr></thead><tbody>
${lines3}</tbody></table></div>
<p class="carts-quiet">${tr("The two forces of a contact have the same size at every instant. How much a velocity changes depends on the mass too.")}</p>
</section>`;
  }
  function lens(baked) {
    const sides = [0, 1].map(
      (k) => html`<g data-side=${k}><rect data-part="body" class="carts-box" y="22" width="720" height="66"/><path data-part="spring" class="carts-spring"/><rect data-part="face" class="carts-face" x="-3" y="34" width="6" height="61" rx="2"/><text data-part="name" class="carts-name" y="42"></text><path data-part="arrow" class="carts-block-arrow"/></g>`
    );
    return html`<section class="carts-view carts-lens" data-view="lens"${closed(baked, "lens")}>
<p class="carts-view-title"><span class="carts-heading">${tr("Lens on the contact, ×{times}", { times: 10 })}</span> <span class="carts-lens-note"></span></p>
<svg viewBox="0 0 360 110" width="360" height="110" aria-hidden="true"><path class="carts-rule" d="M0 96H360"/><path data-part="between" class="carts-coil"/>${sides}<path data-part="was" class="carts-was"/><path data-part="bar" class="carts-rule"/><text data-part="bar-text" y="17"></text><text data-part="when" x="8" y="108"></text></svg>
</section>`;
  }
  function bars(baked) {
    const rows = momenta(baked.run.header).map(
      ([label, style]) => html`<tr class="carts-${style}"><th scope="row">${label}</th><td data-when="before">–</td><td class="carts-bars" aria-hidden="true"><svg viewBox="0 0 128 20" width="128" height="20"><path class="carts-zero" d="M64 0V20"/><rect data-part="before"/><rect data-part="now"/></svg></td><td data-when="now">–</td><td data-when="change">–</td></tr>
`
    );
    return html`<section class="carts-view" data-view="bars"${closed(baked, "bars")}>
<p class="carts-heading">${tr("Momentum before and now")}</p>
<div class="carts-scroll"><table class="carts-table"><thead><tr><th scope="col"><i>p</i>${tr(" in {unit}", { unit: "kg m/s" })}</th><th scope="col">${tr("before,")} <span class="carts-touch-note"></span></th><th scope="col" aria-hidden="true"></th><th scope="col">${tr("now")}</th><th scope="col">${tr("change")}</th></tr></thead><tbody>
${rows}</tbody></table></div>
<p class="carts-quiet">${tr("Hollow: before. Filled: now. + is to the right.")}</p>
</section>`;
  }
  function momenta(header) {
    const around = outside(header);
    const rows = header.bodies.map(({ name }, i) => [name, styleOf(i)]);
    if (around) rows.push([around, "wall"]);
    if (rows.length > 1) rows.push([around ? tr("all together") : tr("all carts"), "total"]);
    return rows;
  }

  // ../view/effects-words.js
  function actingSentences(header, numbers) {
    if (!header.effects.length) return "";
    const acting = header.effects.filter(({ active }) => active).map((effect) => phrase(effect, header, numbers));
    const inside7 = acting.length ? acting.join("; ") : tr("nothing but the contacts between the carts");
    const leftOut = header.notSimulated.map((kind2) => viewOf(kind2).leftOut ?? viewOf(kind2).name);
    const model3 = tr("In this model: {effects}.", { effects: inside7 });
    if (!leftOut.length) return model3;
    const outside2 = tr("Left out: {effects}.", { effects: inRow(leftOut) });
    return `${model3} ${outside2}`;
  }
  function phrase(effect, header, numbers) {
    const { kind: kind2, carts, between: between2 } = effect;
    const view = viewOf(kind2);
    const told3 = {
      everyone: carts.length === header.bodies.length,
      on: listed(carts),
      both: bodiesOf(between2 ?? carts, header.track),
      agent: agent(effect),
      seen: (text3) => numbers ? text3 : ""
    };
    const parts2 = view.phrase?.(effect, told3) ?? [nameOf(effect)];
    return parts2.filter(Boolean).join(", ");
  }
  function forceName({ effects }) {
    return effects.some(isLink) ? tr("Force between them") : tr("Contact force");
  }
  function sizeName({ effects }) {
    return effects.some(isLink) ? tr("Size of the force between them") : tr("Size of the contact force");
  }
  function marks({ effects, until }, forces2) {
    return effects.filter(({ active }) => active).flatMap((effect) => viewOf(effect.kind).marks?.(effect, agent(effect), until, forces2) ?? []);
  }

  // ../view/graph.js
  var LEFT4 = 52;
  var RIGHT4 = 350;
  var TOP4 = 8;
  var BOTTOM4 = 127;
  var WIDTH4 = 360;
  var HEIGHT4 = 160;
  var GAP = 5;
  var WIDEST = 9.2;
  var LETTER2 = 8;
  var BELOW_LINE = 5;
  var [FEW3, ENOUGH, MANY2] = [5, 4, 8];
  var HARDLY = 0.05;
  var NEAR = 0.7;
  var LONG = 8;
  var PIECES = 8;
  var STRAIGHT = 0.05;
  function timeX(plane, t) {
    return LEFT4 + (t - plane.time.low) * ((RIGHT4 - LEFT4) / (plane.time.high - plane.time.low));
  }
  function valueY(plane, value) {
    return BOTTOM4 - (value - plane.value.low) * ((BOTTOM4 - TOP4) / (plane.value.high - plane.value.low));
  }
  function extent(curves, times2) {
    let low = 0;
    let high = 0;
    const take = (value) => {
      if (value < low) low = value;
      if (value > high) high = value;
    };
    for (const { values, slopes } of curves) {
      for (let k = 0; k < values.length; k += 1) {
        take(Number(values[k]));
        const turned = turnAfter(times2, values, slopes, k);
        if (turned !== null) take(turned);
      }
    }
    return [low, high];
  }
  function reached(run, [low, high, factor, room], mirrored = false) {
    const down = Math.min(run[0] * factor, mirrored ? -high : low);
    const up3 = Math.max(run[1] * factor, high);
    const most = room * Math.max(-run[0], run[1]);
    return most > 0 ? [Math.max(down, -most), Math.min(up3, most)] : [down, up3];
  }
  function planeFor(values, window2) {
    return { time: span(window2[0], window2[1], 6), value: readable(values[0], values[1]) };
  }
  function readable(low, high) {
    const plain2 = axis(low, high, FEW3);
    const found = ticks2(plain2);
    const hardly = HARDLY * (high - low);
    const sides = (low >= -hardly || found.some((v) => v < 0)) && (high <= hardly || found.some((v) => v > 0));
    return found.length >= ENOUGH && sides ? plain2 : axis(low, high, MANY2);
  }
  function path(curve3, times2, plane, seen = Infinity) {
    const { values, slopes } = curve3;
    const kx = (RIGHT4 - LEFT4) / (plane.time.high - plane.time.low);
    const ky = (BOTTOM4 - TOP4) / (plane.value.high - plane.value.low);
    const last = times2.length - 1;
    let drawn = 0;
    let x0 = timeX(plane, Number(times2[0]));
    let y0 = valueY(plane, Number(values[0]));
    let d = `M${px(x0)} ${px(y0)}`;
    const isLong = (k, x) => k < last && timeX(plane, Number(times2[k + 1])) - x > LONG;
    for (let k = 1; k <= last; k += 1) {
      if (Number(times2[k]) > seen) return d + tail(curve3, times2, plane, Number(times2[k - 1]), seen);
      const x = timeX(plane, Number(times2[k]));
      const y = valueY(plane, Number(values[k]));
      const near2 = Math.abs(x - x0) < NEAR && Math.abs(y - y0) < NEAR;
      if (k < last && near2 && !isLong(k, x)) continue;
      const third = (Number(times2[k]) - Number(times2[k - 1])) / 3;
      let bent = false;
      if (slopes && drawn === k - 1 && third > 0) {
        const [x1, x2] = [x0 + third * kx, x - third * kx];
        const y1 = y0 - Number(slopes[k - 1]) * third * ky;
        const y2 = y + Number(slopes[k]) * third * ky;
        bent = Math.abs(y1 - (2 * y0 + y) / 3) > STRAIGHT || Math.abs(y2 - (y0 + 2 * y) / 3) > STRAIGHT;
        if (bent) d += `C${px(x1)} ${px(y1)} ${px(x2)} ${px(y2)} ${px(x)} ${px(y)}`;
      }
      if (!bent) d += `L${px(x)} ${px(y)}`;
      drawn = k;
      x0 = x;
      y0 = y;
    }
    return d;
  }
  function tail({ values, slopes }, times2, plane, from, to) {
    let d = "";
    for (let k = 1; k <= PIECES; k += 1) {
      const t = from + (to - from) * k / PIECES;
      d += `L${px(timeX(plane, t))} ${px(valueY(plane, valueAt2(times2, values, slopes, t)))}`;
    }
    return d;
  }
  function timeMarks(plane) {
    const decimals = axisDecimals(plane.time);
    return ticks2(plane.time).map((t) => {
      const at = timeX(plane, t);
      const label = fixed(t, decimals);
      const wide = LETTER2 * (label.length - (decimals > 0 ? 0.5 : 0));
      return { at: px(at), textX: px(Math.min(at, WIDTH4 - wide / 2)), label };
    });
  }
  function valueMarks(plane) {
    const power3 = valuePower(plane);
    const decimals = power3 ? power3 - exponent(plane.value.step) : axisDecimals(plane.value);
    return ticks2(plane.value).map((v) => ({
      at: px(valueY(plane, v)),
      textY: px(valueY(plane, v) + BELOW_LINE),
      label: fixed(v / Number(`1e${power3}`), Math.max(0, decimals)),
      zero: v === 0
    }));
  }
  function valuePower({ value }) {
    const decimals = axisDecimals(value);
    const widths = ticks2(value).map(
      (v) => WIDEST * (fixed(v, decimals).length - (decimals ? 0.5 : 0))
    );
    if (Math.max(...widths) <= LEFT4 - GAP) return 0;
    return exponent(Math.max(Math.abs(value.low), Math.abs(value.high)));
  }

  // ../view/skeleton/graph.js
  var WITH_SIGN = html` <button type="button" class="carts-sign" aria-pressed="false" disabled title=${tr("Show the direction: + means to the right")}>${tr("with sign")}</button>`;
  var LEDGER = html` <button type="button" class="carts-sign carts-stack" aria-pressed="false" disabled title=${tr("Kinetic energy, squeezed bumpers and warmth on top of each other")}>${tr("as a ledger")}</button>`;
  var TOGGLES = { F: WITH_SIGN, energy: LEDGER };
  function graph({ fence, view, run }, quantity) {
    const [title, symbol, unit] = QUANTITIES[quantity] ?? ["", "", ""];
    const isForce = quantity === "F";
    const name = isForce ? sizeName(run.header) : title;
    const camera = fence.camera && ["x", "v"].includes(quantity) ? tr("seen from the camera, ") : "";
    const measured2 = quantity === "v" ? speedUnit(view.velocity)[1] : unit;
    const label = tr("{quantity} against time", { quantity: name });
    const table4 = tr("Table: {quantity}", { quantity: lower(name) });
    return html`<div class="carts-graph" data-quantity=${quantity} role="group" aria-label=${label}>
<p class="carts-graph-title"><span class="carts-graph-name">${name} ${camera}<i>${isForce ? "|F|" : symbol}</i>${tr(" in {unit}", { unit: measured2 })}</span>${TOGGLES[quantity]}</p>
${plot(`${fence.id}-${quantity}-clip`, isForce, fence.watch === "first")}
<p class="carts-key"></p>
${isForce && html`<p class="carts-area-note carts-quiet">\u00a0</p>`}
<details class="carts-more"><summary>${table4}</summary>
<div class="carts-scroll"><table class="carts-table"><thead><tr><th scope="col">${tr("t in s")}</th></tr></thead><tbody></tbody></table></div></details>
</div>`;
  }
  function plot(clip, isForce, growing) {
    const inside7 = html`clip-path="url(#${clip})"`;
    const shade = html`<path class="carts-impulse" d=""/>`;
    const room = html`<rect x=${LEFT4} y=${TOP4 - 4} width=${RIGHT4 - LEFT4 + 1} height=${BOTTOM4 - TOP4 + 8}/>`;
    const seen = `${clip}-seen`;
    return html`<svg class="carts-plot" viewBox="0 0 ${WIDTH4} ${HEIGHT4}" width=${WIDTH4} height=${HEIGHT4} aria-hidden="true">
<defs><clipPath id=${clip}>${room}</clipPath>${growing && html`<clipPath id=${seen} class="carts-seen">${room}</clipPath>`}</defs>
<g data-part="times"></g>
<g data-part="values"></g>
<text class="carts-unit" x=${RIGHT4} y=${HEIGHT4 - 3} text-anchor="end">${tr("time t in s")}</text>
<g data-part="areas" clip-path="url(#${growing ? seen : clip})">${isForce && [shade, shade]}</g>
<g data-part="curves" ${inside7}></g>
<g data-part="cursor" ${inside7}><path class="carts-cursor" d="M0 ${TOP4}V${BOTTOM4}" transform="translate(${LEFT4} 0)"/></g>
</svg>`;
  }

  // ../view/skeleton/panel.js
  function panel(baked) {
    const { fence } = baked;
    const { controls, switches, presets } = fence;
    const names = Object.keys(presets);
    const buttons = names.map(
      (name) => html`<button type="button" class="carts-button carts-preset" data-preset=${name} disabled>${name}</button>`
    );
    const all = fence.watch === "first" && names.length > 1;
    const left = all && html` <span class="carts-presets-left" role="status">${tr("Watch each of them once.")}</span>`;
    const back = controls.length || switches.length || names.length;
    return html`<div class="carts-side">
${names.length > 0 && html`<p class="carts-presets" role="group" aria-label=${tr("Ready-made settings")}>${buttons}${left}</p>`}
<div class="carts-panel">
${cartCards(baked)}
${otherCards(baked)}
${effectCard(baked)}
</div>
<div class="carts-warnings" hidden></div>
<details class="carts-more carts-take"><summary>${tr("Take it along")}</summary></details>
${back > 0 && html`<p class="carts-reset-row"><button type="button" class="carts-button carts-undo" disabled>${tr("Undo")}</button> <button type="button" class="carts-button carts-reset" disabled>${tr("Reset all values")}</button></p>`}
</div>`;
  }
  function cartCards(baked) {
    const { fence, run } = baked;
    return run.header.bodies.map(({ name }, i) => {
      const style = `carts-${styleOf(i)}`;
      const title = isWord(name) ? name : tr("Cart {name}", { name });
      const own = fence.controls.filter(({ set }) => ownerOf(set) === name);
      return html`<div class="carts-card ${style}" role="group" aria-label=${title} data-body=${name}>
<p class="carts-heading"><svg class="carts-swatch" viewBox="0 0 26 12" width="26" height="12" aria-hidden="true"><path class="carts-curve ${style}" d="M0 6H26"/><path class="carts-dot ${style}" d=${MARKERS[styleOf(i)]} transform="translate(13 6)"/></svg>${title}</p>
${own.map((one) => control(one, fence.id))}
<dl class="carts-readouts">${readouts(baked)}</dl></div>
`;
    });
  }
  function readouts({ fence, view }) {
    const { camera, forces: forces2 } = fence;
    const speed = speedUnit(view.velocity)[1];
    const rows = [
      [tr("mass"), "m", "mass", "kg"],
      [camera ? tr("position seen from the camera") : tr("position"), "x", "x", "m"],
      [camera ? tr("velocity seen from the camera") : tr("velocity"), "v", "v", speed]
    ];
    if (forces2 === "shown") {
      rows.push([tr("resultant force"), "R", "F", "N"], [tr("acceleration"), "a", "a", "m/s²"]);
    }
    return rows.map(
      ([name, symbol, quantity, unit]) => html`<div><dt><span class="carts-word">${name} </span><i>${symbol}</i></dt><dd><span class="carts-value" data-quantity=${quantity}></span> ${unit}</dd></div>`
    );
  }
  function otherCards({ fence, run: { header } }) {
    const owners = header.bodies.map(({ name }) => name);
    const contact = fence.controls.filter(({ set }) => ownerOf(set) === "contact");
    const rest = fence.controls.filter(
      ({ set }) => ![...owners, "contact", "effects"].includes(ownerOf(set)) && !effectOf(set, header)
    );
    const cards = [
      [tr("Contact"), contact],
      [tr("Scene"), rest]
    ];
    return cards.filter(([, own]) => own.length).map(
      ([title, own]) => html`<div class="carts-card" role="group" aria-label=${title}>
<p class="carts-heading">${title}</p>
${own.map((one) => control(one, fence.id))}</div>
`
    );
  }
  function effectCard({ fence, run: { header } }) {
    const own = fence.controls.filter(({ set }) => effectOf(set, header));
    if (!own.length && !fence.switches.length) return null;
    const title = tr("What acts");
    const boxes = fence.switches.map(
      ({ set, label, value }) => html`<div class="carts-switch"><label><input type="checkbox" data-switch=${set} autocomplete="off"${value && html` checked`} disabled> <span>${label}</span></label><p class="carts-error" hidden></p></div>`
    );
    return html`<div class="carts-card carts-effect-card" role="group" aria-label=${title}>
<p class="carts-heading">${title}</p>
${boxes}
${own.map((one) => control(one, fence.id))}</div>`;
  }
  function control({ set, label, short: short2, unit, low, high, step, value }, id) {
    const decimals = Math.max(...[step, low, value].map((one) => decimalsOf(one)));
    const text3 = fixed(value, decimals).replace("−", "-");
    const box2 = `${id}-${set.replaceAll(".", "-")}`;
    const slider2 = tr("{label}, slider", { label });
    const measured2 = unit ? tr(" in {unit}", { unit }) : "";
    return html`<div class="carts-control" data-set=${set}>
<label for=${box2}>${short2}</label>
<input type="range" class="carts-slider" min=${low} max=${high} step=${step} value=${value} aria-label=${slider2} aria-valuetext="${text3} ${unit}" disabled>
<span class="carts-typed"><input type="text" class="carts-number-box" id=${box2} inputmode="decimal" autocomplete="off" spellcheck="false" value=${text3} aria-label="${label}${measured2}" disabled> <span class="carts-unit-text">${unit}</span></span>
<p class="carts-error" hidden></p>
</div>
`;
  }
  var ownerOf = (set) => set.split(".")[0] ?? "";

  // ../view/pad.js
  var LEFT5 = 40;
  var STEP = 77.5;
  var POINTS = 5;
  var HIGHEST = 10;
  var TOP5 = 10;
  var BOTTOM5 = 130;
  function pad(quantity) {
    const low = quantity === "F" ? 0 : -HIGHEST;
    const per = (BOTTOM5 - TOP5) / (HIGHEST - low);
    return { low, zero: TOP5 + HIGHEST * per, per };
  }
  function path2({ zero, per }, heights) {
    const step = (POINTS - 1) * STEP / (heights.length - 1);
    const points = Array.from(
      heights,
      (height, k) => `${px(LEFT5 + k * step)} ${px(zero - per * height)}`
    );
    return `M${points.join("L")}`;
  }

  // ../view/skeleton/predict.js
  var FULL = 10;
  var STEP2 = 0.05;
  var CERTAINTY = [
    ["guess", tr("a guess")],
    ["think", tr("I think so")],
    ["sure", tr("I am sure")]
  ];
  var TIMES2 = {
    contact: [
      tr("at first touch"),
      tr("after a quarter"),
      tr("in the middle"),
      tr("after three quarters"),
      tr("at the end")
    ],
    run: [
      tr("at the start"),
      tr("after a quarter"),
      tr("in the middle"),
      tr("after three quarters"),
      tr("at the end")
    ]
  };
  var KNOBS = Array.from({ length: POINTS }, (_, k) => k);
  var FORMS2 = { arrows, curve: curve2, choice: choice2, text };
  function predict(baked, spec) {
    const { id } = baked.fence;
    const lock = spec.talk ? tr("Lock my prediction") : tr("Lock my prediction and show the run");
    return html`<div class="carts-predict" data-kind=${spec.kind} role="group" aria-labelledby="${id}-ask">
<p class="carts-heading">${tr("Predict first")}</p>
<p class="carts-ask" id="${id}-ask">${spec.ask}</p>
${FORMS2[spec.kind](baked, spec)}
${spec.sure && certainty(id)}
<p class="carts-lock-row"><button type="button" class="carts-button carts-lock" disabled>${lock}</button> <span class="carts-saved" role="status"></span></p>
<p class="carts-error carts-predict-error" role="alert" hidden></p>
<div class="carts-talk" tabindex="-1" role="group" aria-label=${tr("Talk with your partner")} hidden><p><b>${tr("Locked.")}</b> ${tr("Now tell your partner what you expect, and why. Listen to the other reason too. You may change your prediction once; both are kept.")}</p><p class="carts-lock-row"><button type="button" class="carts-button carts-talk-change">${tr("Change it once")}</button> <button type="button" class="carts-button carts-talk-run">${tr("Keep it and show the run")}</button></p></div>
<div class="carts-compared" tabindex="-1" hidden></div>
<label class="carts-why" hidden>${tr("Explain: what did you see, and why is it so?")} <textarea rows="3" maxlength="20000" autocomplete="off" placeholder=" "></textarea></label>
<div class="carts-write" aria-hidden="true"><hr><hr><hr><hr></div>
<p class="carts-lock-row carts-again-row" hidden><button type="button" class="carts-button carts-again">${tr("Start again")}</button><span class="carts-forget" hidden>${tr("Forget this prediction and what was written below it?")} <button type="button" class="carts-button carts-forget-yes">${tr("Forget it")}</button> <button type="button" class="carts-button carts-forget-no">${tr("Keep it")}</button></span></p>
</div>`;
  }
  function certainty(id) {
    const label = tr("How sure are you?");
    const choices = CERTAINTY.map(
      ([word, says]) => html`<label><input type="radio" autocomplete="off" name="${id}-sure" value=${word} disabled> ${says}</label> `
    );
    return html`<p class="carts-certainty" role="radiogroup" aria-label=${label}><span>${label}</span> ${choices}</p>`;
  }
  function arrows({ fence, view, run: { header } }, { pairs, scale }) {
    const numbers = scale === "newtons";
    const full = numbers ? view.force || FULL : 1;
    const step = numbers ? niceAbove(full / 100) : STEP2;
    const asked = pairs.flatMap(([left, right]) => [
      { pair: `${left}-${right}`, on: left, by: right },
      { pair: `${left}-${right}`, on: right, by: left }
    ]);
    const rows = asked.map(({ pair, on, by }, k) => {
      const i = header.bodies.findIndex(({ name }) => name === on);
      const force = forceOn(body(on, header.track), body(by, header.track));
      const label = tr("{force}, length of the arrow", { force });
      const id = `${fence.id}-guess-${k + 1}`;
      return html`<div class="carts-guess carts-${i < 0 ? "wall" : styleOf(i)}" data-pair=${pair} data-on=${on}><label for=${id}>${force}</label><input type="range" autocomplete="off" min="0" max=${full} step=${step} value="0" aria-label=${label}${!numbers && html` id=${id}`} disabled>${numbers && html`<span class="carts-typed"><input type="text" class="carts-number-box" id=${id} inputmode="decimal" autocomplete="off" value="" disabled> <span class="carts-unit-text">N</span></span><p class="carts-error" hidden></p>`}</div>
`;
    });
    const how = tr(
      "Pull each arrow in the picture, or here, until it is as long as you think. Only which one is longer counts, not how many newtons."
    );
    const paper = tr(
      "On paper: draw an arrow from each dot. The stronger you think the force is, the longer."
    );
    return html`${!numbers && html`<p class="carts-quiet carts-pull-how">${how}</p>`}<p class="carts-quiet carts-draw-how">${paper}</p><div class="carts-guesses">
${rows}</div>${!numbers && html`<p class="carts-relation" role="status"></p>`}`;
  }
  function curve2({ run: { header } }, { cart: cart2, quantity }) {
    const i = header.bodies.findIndex(({ name }) => name === cart2);
    const place2 = pad(quantity);
    const knobs = KNOBS.map(
      (k) => html`<circle class="carts-knob" data-index=${k} cx=${LEFT5 + STEP * k} cy=${place2.zero} r="7"/>`
    );
    const mode = place2.low < 0 ? "text" : "decimal";
    const heights = TIMES2[quantity === "F" ? "contact" : "run"].map(
      (name) => html`<label>${name} <input type="text" class="carts-height" inputmode=${mode} autocomplete="off" disabled></label>`
    );
    const flat = path2(place2, [0, 0, 0, 0, 0]);
    return html`<div class="carts-sketch">
<svg class="carts-pad" viewBox="0 0 360 170" width="360" height="170" aria-hidden="true"><path class="carts-grid" d="M40 10V130M40 130H350M117.5 10V130M195 10V130M272.5 10V130M350 10V130M40 70H350M40 10H350"/>${axes(quantity)}<path data-part="answer" class="carts-curve carts-${styleOf(Math.max(0, i))}" d=""/><path data-part="sketch" class="carts-sketch-line" d=${flat}/>${knobs}</svg>
<div class="carts-heights"><p>${quantity === "F" ? tr("Move the five points, or type heights from 0 to 10.") : tr("Move the five points, or type heights from −10 to 10: right is positive.")}</p>${heights}</div>
</div>`;
  }
  function axes(quantity) {
    if (quantity === "F")
      return html`<text x="40" y="147">${tr("touch")}</text><text x="350" y="147" text-anchor="end">${tr("apart")}</text><text x="195" y="164" text-anchor="middle">${tr("time during the contact")}</text><text class="carts-pad-up" x="34" y="16" text-anchor="end">${tr("large")}</text><text x="28" y="134" text-anchor="end">0</text>`;
    const middle = quantity === "v" ? tr("at rest") : tr("start");
    return html`<text data-way="1" x="46" y="24">${tr("to the right")}</text><text data-way="-1" x="46" y="126">${tr("to the left")}</text><text data-way="0" x="311" y="61" text-anchor="middle">${middle}</text><text x="195" y="164" text-anchor="middle">${tr("time from start to end")}</text>`;
  }
  function choice2({ fence: { id } }, { options }) {
    const rows = options.map(
      (option, k) => html`<label><input type="radio" autocomplete="off" name="${id}-predict" value=${k} disabled> <span>${option}</span></label>`
    );
    return html`<div class="carts-options" role="radiogroup" aria-labelledby="${id}-ask">${rows}</div>`;
  }
  function text({ fence: { id } }) {
    return html`<textarea class="carts-words" rows="3" maxlength="20000" autocomplete="off" aria-labelledby="${id}-ask" disabled></textarea>`;
  }

  // ../view/skins.js
  var NARROW = 24;
  var GAP2 = 5;
  var SADDLE = 6;
  var SKINS = {
    cart: { wheels: true, lift: 0, corner: 4, lines: () => "" },
    van: { wheels: true, lift: 0, corner: 7, lines: van },
    truck: { wheels: true, lift: 0, corner: 3, lines: truck },
    trailer: { wheels: true, lift: 0, corner: 1, lines: trailer },
    box: { wheels: false, lift: 0, corner: 1, lines: crate },
    puck: { wheels: false, lift: 0, corner: 12, lines: puck },
    glider: { wheels: false, lift: GAP2, corner: 4, lines: glider }
  };
  function van(box2, front) {
    return lines2(box2, front, [
      [
        [0.06, 0.9],
        [0.34, 0.9],
        [0.46, 0.68],
        [0.06, 0.68],
        [0.06, 0.9]
      ],
      [
        [-0.42, 0.9],
        [-0.08, 0.9],
        [-0.08, 0.68],
        [-0.42, 0.68],
        [-0.42, 0.9]
      ],
      [
        [0.4, 0.26],
        [0.5, 0.26]
      ]
    ]);
  }
  function truck(box2, front) {
    return lines2(box2, front, [
      [
        [0.22, 0],
        [0.22, 1]
      ],
      [
        [0.28, 0.9],
        [0.42, 0.9],
        [0.46, 0.66],
        [0.28, 0.66],
        [0.28, 0.9]
      ],
      [
        [-0.5, 0.16],
        [0.22, 0.16]
      ]
    ]);
  }
  function trailer(box2, front) {
    return lines2(box2, front, [
      [
        [-0.5, 0.2],
        [0.5, 0.2]
      ],
      ...[-0.4, -0.27, 0.27, 0.4].map(
        (x) => [
          [x, 0.2],
          [x, 1]
        ]
      )
    ]);
  }
  function crate(box2, front) {
    return lines2(box2, front, [
      [
        [-0.4, 0.1],
        [0.4, 0.1],
        [0.4, 0.9],
        [-0.4, 0.9],
        [-0.4, 0.1]
      ],
      [
        [-0.4, 0.3],
        [-0.22, 0.1]
      ],
      [
        [0.4, 0.3],
        [0.22, 0.1]
      ],
      [
        [-0.4, 0.7],
        [-0.22, 0.9]
      ],
      [
        [0.4, 0.7],
        [0.22, 0.9]
      ]
    ]);
  }
  function puck(box2, front) {
    return lines2(box2, front, [
      [
        [-0.48, 0.15],
        [0.48, 0.15]
      ],
      [
        [-0.48, 0.85],
        [0.48, 0.85]
      ]
    ]);
  }
  function glider(box2, front) {
    const top = Math.min(SADDLE / box2.height, 0.4);
    return lines2(box2, front, [
      [
        [-0.5, top],
        [0.5, top]
      ],
      ...[-0.42, -0.28, 0.28, 0.42].map(
        (x) => [
          [x, 0],
          [x, top]
        ]
      )
    ]);
  }
  function lines2({ width, height }, front, strokes) {
    if (width < NARROW) return "";
    const at = ([x, y]) => `${px(front * x * width)} ${px(-y * height)}`;
    return strokes.map((points) => `M${points.map(at).join("L")}`).join("");
  }

  // ../view/skeleton/tools.js
  var STEPS = 500;
  var AT_FIRST = [0.25, 0.5];
  var HANDLE = 8;
  function tools({ fence, view }) {
    const layout = view.layouts[0];
    const watch = fence.opened.includes("stopwatch");
    if (!layout?.tape && !watch) return null;
    return html`<div class="carts-tools">
${watch && stopwatch()}
${layout && layout.tape > 0 && ruler(layout)}
</div>`;
  }
  function stopwatch() {
    const name = tr("Stopwatch");
    return html`<div class="carts-tool" role="group" aria-label=${name} data-tool="stopwatch"><span class="carts-heading">${name}</span> <span class="carts-tool-read"><output aria-live="off">0.00</output> s</span> <button type="button" class="carts-button" data-act="stop" data-stop=${tr("Stop")} data-start=${tr("Start")}>${tr("Start")}</button> <button type="button" class="carts-button" data-act="zero">${tr("Zero")}</button></div>`;
  }
  function ruler(layout) {
    const name = tr("Ruler");
    const step = stepOf(layout);
    const decimals = decimalsOf(step);
    const [from, to] = ends(layout);
    const end2 = (key2, label, x) => html`<input type="range" data-end=${key2} min=${px(layout.low, decimals)} max=${px(layout.high, decimals)} step=${step} value=${px(x, decimals)} autocomplete="off" aria-label=${label} aria-valuetext="${fixed(x, decimals)} m">`;
    return html`<div class="carts-tool" role="group" aria-label=${name} data-tool="ruler" data-decimals=${decimals}><span class="carts-heading">${name}</span> ${end2("from", tr("left end of the ruler"), from)}${end2("to", tr("right end of the ruler"), to)} <span class="carts-tool-read"><output>${fixed(to - from, decimals)}</output> m</span></div>`;
  }
  function tape(layout) {
    const at = (x) => px(layout.origin + x * layout.scale);
    const [from, to] = ends(layout);
    const y = px(layout.tape);
    const numbers = layout.track + layout.beam;
    const line2 = `M0 ${px(layout.track - 36)}V${px(numbers + 8)}M0 ${px(numbers + 27)}V${y}`;
    const end2 = (key2, x) => html`<g class="carts-tape-end" data-end=${key2} transform="translate(${at(x)} 0)"><path d=${line2}/><circle class="carts-pull-room" cx="0" cy=${y} r="16"/><circle cx="0" cy=${y} r=${HANDLE}/></g>`;
    const middle = at((from + to) / 2);
    return html`<g class="carts-tape" data-origin=${px(layout.origin, 4)} data-scale=${px(layout.scale, 4)} data-y=${y}><path data-part="tape" d="M${at(from)} ${y}H${at(to)}"/>${end2("from", from)}${end2("to", to)}<text data-part="length" x=${middle} y=${px(layout.tape + 5)} text-anchor="middle">${fixed(to - from, decimalsOf(stepOf(layout)))} m</text></g>`;
  }
  function stepOf({ low, high }) {
    return niceAbove((high - low) / STEPS);
  }
  function ends(layout) {
    const { low, high } = layout;
    const step = stepOf(layout);
    const [from, to] = AT_FIRST.map((part) => Math.round((low + part * (high - low)) / step) * step);
    return [from ?? low, to ?? high];
  }

  // ../view/skeleton/stage.js
  var LABEL_ROOM = { wide: 54, narrow: 46 };
  var BREAK = "M-14 -56l7 -6l7 6l7 -6l7 6M-14 -49l7 -6l7 6l7 -6l7 6";
  var MOST_NUMBERS2 = 150;
  var LETTER3 = 8;
  var BEYOND = 60;
  function stage(baked, layout) {
    const { fence, run } = baked;
    const { kind: kind2, width, height } = layout;
    const forces2 = fence.forces === "shown";
    const hatch = `${fence.id}-${kind2}-hatch`;
    const size = html`viewBox="0 0 ${px(width)} ${px(height)}" width=${px(width)} height=${px(height)}`;
    return html`<svg class="carts-stage carts-stage-${kind2}" data-kind=${kind2} ${size} aria-hidden="true">
<defs>
<pattern id=${hatch} width="8" height="8" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><path class="carts-hatch" d="M0 0V8"/></pattern>
</defs>
${ground(baked, layout, hatch)}
<g data-part="effects-behind"></g>
${run.header.bodies.map(velocity)}
${run.header.bodies.map((body2, i) => cart(body2.name, i, fence.skins[body2.name] ?? "cart"))}
${run.header.bodies.map(({ name }) => html`<text class="carts-mass" data-body=${name}></text>`)}
<path class="carts-was"/>
<g data-part="effects-front"></g>
${forces2 && pushes2(baked)}
<g data-part="guess"></g>
${layout.tape > 0 && tape(layout)}
${legend(baked, layout)}
</svg>`;
  }
  function velocity({ name }, i) {
    return html`<g class="carts-velocity carts-${styleOf(i)}" data-body=${name}><path data-part="leader" class="carts-leader"/><path data-part="arrow" class="carts-line-arrow"/><text data-part="text"></text></g>
`;
  }
  function cart(name, i, skin) {
    const { corner, wheels: wheels2 } = SKINS[skin];
    const face2 = (side2) => html`<rect data-part="face-${side2}" class="carts-face" x="-1.5" y="-22" width="3" height="21" rx="1.5"/>`;
    return html`<g class="carts-cart carts-${styleOf(i)}" data-body=${name}><path data-part="spring-left" class="carts-spring"/><path data-part="spring-right" class="carts-spring"/>${face2("left")}${face2("right")}<rect data-part="box" class="carts-box" rx=${corner}/>${skin !== "cart" && html`<path data-part="skin" class="carts-skin"/>`}${wheels2 && html`<path data-part="wheels" class="carts-wheels"/>`}<g data-part="break" class="carts-break"><path d=${BREAK}/></g><text data-part="name" class="carts-name"></text></g>
`;
  }
  function pushes2({ run: { header } }) {
    const linked = linkedPairs(header);
    const style = (name) => {
      const i = header.bodies.findIndex((body2) => body2.name === name);
      return i < 0 ? "wall" : styleOf(i);
    };
    return header.contacts.filter(({ stiffness, pair }) => stiffness || linked.has(pair)).flatMap(
      ({ pair, bodies }) => bodies.map(
        (on) => html`<g class="carts-push carts-${style(on)}" data-pair=${pair} data-on=${on}><path data-part="arrow" class="carts-block-arrow"/><text data-part="text" visibility="hidden"></text></g>
`
      )
    );
  }
  function ground({ fence, run: { header } }, layout, hatch) {
    const travel = fence.camera * header.until;
    const [low, high] = [layout.low + Math.min(0, travel), layout.high + Math.max(0, travel)];
    const { left, right, length } = header.track;
    const at = (x) => layout.origin + x * layout.scale;
    const first = left === "wall" ? 0 : low;
    const last = right === "wall" ? Number(length) : high;
    const slider2 = fence.controls.find((control2) => control2.set === "track.length");
    const longest = slider2 ? slider2.high * slider2.per : last;
    const start = left === "wall" ? at(0) : at(low) - BEYOND;
    const end2 = right === "wall" ? at(last) : at(high) + BEYOND;
    const under3 = layout.track + layout.beam;
    let step = niceAbove((LABEL_ROOM[layout.kind] ?? 0) / layout.scale);
    while ((high - low) / step > MOST_NUMBERS2) step = niceAbove(step * 1.5);
    const numbers = { low: first, high: Math.max(last, longest), step };
    const parts2 = /[1-9]/.exec(short(step))?.[0] === "2" ? 4 : 5;
    const fine = ticks2({ ...numbers, step: step / parts2 }).map((x) => `M${px(at(x))} ${px(under3)}v4`);
    const wall = (side2) => html`<g data-wall=${side2}><path class="carts-wall"/><path fill="url(#${hatch})"/><path class="carts-wall-face"/></g>
`;
    return html`<g data-part="ground">
${left === "wall" && wall("left")}${right === "wall" && wall("right")}<rect class="carts-beam" x=${px(start)} y=${px(layout.track)} width=${px(end2 - start)} height=${px(layout.beam)}/>
<path class="carts-rule" d="M${px(start)} ${px(layout.track)}H${px(end2)}"/>
<path class="carts-fine" d=${fine.join("")}/>
${ticks2(numbers).map(
      (x) => html`<path class="carts-fine" d="M${px(at(x))} ${px(under3)}v8"/><text class="carts-number" x=${px(at(x))} y=${px(under3 + 22)}>${fixed(x, axisDecimals(numbers))}</text>
`
    )}</g>`;
  }
  function legend({ fence, view }, layout) {
    const y = layout.height - 10;
    const wide = layout.kind === "wide";
    const [per, unit] = speedUnit(view.velocity);
    const text3 = (x2, said) => html`<text x=${px(x2)} y=${px(y + 5)}>${said}</text>`;
    const force = fence.forces === "shown" && view.force > 0;
    const asked = fence.predict?.kind === "arrows" ? "" : "carts-unasked";
    const word = tr("scale:");
    const start = layout.above ? 12 : 12 + roomOf(word) + 4;
    const next = start + layout.velocity + 6;
    const x = next + 68;
    const end2 = force ? x + layout.force + 6 : next;
    const axis2 = wide ? tr("x in m, + is to the right") : tr("x in m, + →");
    const moving = wide ? tr("position on the track in m") : tr("track in m");
    return html`<g class="carts-legend">
<text x="12" y=${px(layout.above ? y - 9 : y + 5)}>${word}</text>
<path class="carts-line-arrow" d=${lineArrow(start, y, layout.velocity)}/>${text3(next, `${short(view.velocity / per)} ${unit}`)}
${force && html`<g class=${asked}><path class="carts-block-arrow" d=${blockArrow(x, y, layout.force)}/>${text3(end2, `${short(view.force)} N`)}</g>`}
${wide && html`<text class="carts-torn" data-now="no" x=${px(end2 + 70)} y=${px(y + 5)}>${tr("torn: not to scale")}</text>`}
<text x=${px(layout.width - 12)} y=${px(y + 5)} text-anchor="end">${fence.camera ? moving : axis2}</text>
</g>`;
  }
  function roomOf(word) {
    return [...word].reduce((sum, sign) => sum + (sign > "˿" ? 2 * LETTER3 : LETTER3), 0);
  }

  // ../view/skeleton/time.js
  var LONG2 = 60;
  var SPEEDS = [1, 10, 100];
  var START2 = "M3 3v10M13 3L6 8l7 5z";
  var BACK2 = "M12.5 3v10M10 3L3 8l7 5z";
  var FORWARD = "M3.5 3v10M6 3l7 5-7 5z";
  function timeline({ run: { header } }) {
    return html`<div class="carts-timeline">
<svg class="carts-ticks" width="100%" height="34" aria-hidden="true"><g data-part="contacts"></g><g data-part="events"></g><g data-part="numbers"></g></svg>
<input type="range" class="carts-scrub" min="0" max=${header.until} step="any" value="0" aria-label=${tr("Time")} disabled>
</div>`;
  }
  function transport({ fence, run: { header } }) {
    const slow = fence.slow !== "never" && header.contacts.some(({ stiffness }) => stiffness);
    const speed = openingSpeed(header.until);
    const speeds = SPEEDS.map(
      (n) => html`<option value=${n}${n === speed && html` selected`}>${n}×</option>`
    );
    return html`<div class="carts-transport">
${button("start", START2, tr("Back to the start"), tr("Back to the start (Home)"))}
${button("back", BACK2, tr("Step back"), tr("Step back (left arrow key)"))}
<button type="button" class="carts-button carts-play" title=${tr("Play or pause (space bar)")} disabled><svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path class="carts-icon-play" d="M4 2.5L13 8l-9 5.5z"/><path class="carts-icon-pause" d="M4 3h3v10H4zM9 3h3v10H9z"/></svg><span>${tr("Play")}</span></button>
${button("forward", FORWARD, tr("Step forward"), tr("Step forward (right arrow key)"))}
<label class="carts-speed-label">${tr("Speed")} <select autocomplete="off" class="carts-speed" disabled><option value="0.01">1/100</option><option value="0.1">1/10</option>${speeds}</select></label> <a class="carts-jump carts-down" href="#${fence.id}-graphs">${tr("Graphs")} ↓</a>
${slow && html`<label class="carts-slow-label"><input type="checkbox" class="carts-slow" checked disabled> ${tr("slow motion in contacts")}</label>`}
<p class="carts-clocks"><span>${tr("cart time")} <span class="carts-clock">0.000</span> s</span>${slow && html`<span class="carts-slow-note" aria-hidden="true"><b class="carts-rate">1×</b> ${tr("speed, your time")} <span class="carts-own-clock">0.0</span> s</span>`}</p>
${fence.watch === "first" && html`<button type="button" class="carts-button carts-end" disabled>${tr("Show me the end")}</button>`}
</div>`;
  }
  function button(name, icon, label, title) {
    return html`<button type="button" class="carts-button carts-${name}" aria-label=${label} title=${title} disabled><svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path d=${icon}/></svg></button>`;
  }
  function openingSpeed(until) {
    if (until <= LONG2) return 1;
    return until >= 10 * LONG2 ? 100 : 10;
  }

  // ../view/skeleton/scene.js
  var FORCE_QUANTITIES = ["F", "R", "a"];
  function inside5(baked, found = false) {
    const { fence, view, run } = baked;
    const { id, predict: asked } = fence;
    const quantities = fence.show.filter(
      (quantity) => fence.forces === "shown" || !FORCE_QUANTITIES.includes(quantity)
    );
    const paper = asked ? tr("Make your prediction on paper. The run needs JavaScript.") : tr("The picture shows the start. Playing the run needs JavaScript.");
    return html`<div class="carts-frame" role="group" aria-labelledby="${id}-title">
<div class="carts-top"><p class="carts-title" id="${id}-title">${run.header.title ?? tr("Carts on an air track")}</p><button type="button" class="carts-sign carts-project" title=${tr("Full screen for the class (key P)")} aria-pressed="false" disabled>${tr("projector")}</button>${liveMark()}</div>
<div class="carts-note" role="status" hidden></div>
<div class="carts-world" tabindex="0" role="group" aria-label=${tr("Carts on the track")} aria-describedby="${id}-described ${id}-keys">
${view.layouts.map((layout) => stage(baked, layout))}
<p class="carts-torn" data-now="no"${!view.mayTear && html` hidden`}>${tr("A torn box is not to scale: its cart is heavier.")}</p>
${run.header.effects.length > 0 && html`<p class="carts-acting"></p>`}
${fence.camera !== 0 && html`<p class="carts-camera">${cameraText(fence.camera)}</p>`}
</div>
<p class="carts-hidden" id="${id}-described">${description(baked)}</p>
<p class="carts-hidden" id="${id}-keys">${tr("The space bar plays and pauses, the arrow keys step.")}</p>
${timeline(baked)}
${transport(baked)}
${tools(baked)}
<noscript><p class="carts-noscript">${paper}</p></noscript>
${asked && predict(baked, asked)}
${near(baked)}
${panel(baked)}
${views(baked)}
<div class="carts-results" id="${id}-graphs"${asked && html` hidden`}>
<div class="carts-graphs-bar"><details class="carts-more carts-choose"><summary>${tr("Choose what to see")}</summary><div class="carts-choices"></div></details><label>${tr("Time axis")} <select class="carts-window" disabled><option value="">${tr("whole run")}</option></select></label></div>
<div class="carts-graphs">
${quantities.map((quantity) => graph(baked, quantity))}
<div class="carts-story"><p class="carts-heading">${tr("What happens")}</p>
<ol class="carts-events" aria-label=${tr("What happens")}></ol></div>
</div>
${asksForForces(baked) && find2()}${found && html`<p class="carts-found" hidden></p>`}
</div>
<details class="carts-more carts-model"${asksForForces(baked) && html` hidden`}><summary>${tr("What is in this model")}</summary><ul></ul></details>
<details class="carts-more carts-how"><summary>${tr("How is this computed?")}</summary><div class="carts-how-body"></div><noscript><p>${tr("Every run is computed exactly, formula by formula. How this one was needs JavaScript.")}</p></noscript></details>
<div class="carts-hidden carts-announcer" aria-live="polite"></div>
</div>`;
  }
  function asksForForces({ fence, run }) {
    return fence.forces === "hidden" && run.header.contacts.some(({ stiffness }) => stiffness);
  }
  function find2() {
    const [before2, after2] = tr(
      "While they touch, the mean force on a cart is {formula}. Read its velocity before and after off the graph or its table, and the times off “What happens”."
    ).split("{formula}");
    return html`<details class="carts-more carts-find" open><summary>${tr("The forces are hidden. Find those on both carts, and you see them all")}</summary><p>${before2}<i>F</i> = <i>m</i> · Δ<i>v</i> / Δ<i>t</i>${after2}</p><form class="carts-find-form"><label>${tr("Mean force on")} <select class="carts-find-which" disabled></select></label> <span class="carts-find-value"><input type="text" inputmode="decimal" autocomplete="off" aria-label=${tr("mean force in N, plus is to the right")} disabled> N</span> <button type="submit" class="carts-button" disabled>${tr("Check")}</button></form><p class="carts-find-note" role="status"></p></details>`;
  }
  function description({ fence: { camera }, view, run: { header } }) {
    const carts = header.bodies.map(({ name, mass, position, velocity: velocity2 }) => {
      const told3 = { cart: name, mass: short(mass), place: fixed(position, 2) };
      if (velocity2 === camera) return tr("{cart}, {mass} kg, is at {place} m and is at rest.", told3);
      const seen = motion(velocity2 - camera, view.decimals.v ?? 2, view.velocity);
      return tr("{cart}, {mass} kg, is at {place} m and moves at {velocity}.", {
        ...told3,
        velocity: seen
      });
    });
    return tr("At the start: {carts}", { carts: carts.join(" ") });
  }
  function cameraText(camera) {
    return tr(
      "Seen from a camera that moves at {velocity} along the track. Positions and velocities are measured from the camera.",
      { velocity: motion(camera, 2, Math.abs(camera)) }
    );
  }

  // ../view/windows.js
  function touches(events, until) {
    const open2 = /* @__PURE__ */ new Map();
    const peaks = /* @__PURE__ */ new Map();
    const anew = /* @__PURE__ */ new Map();
    const found = [];
    for (const event of events) {
      const { bodies, before: before2, t: start } = event;
      const pair = bodies.join("-");
      const touch = { pair, bodies, start, end: start };
      if (event.kind === "contact" && !event.impulse) {
        const old = open2.get(pair);
        if (old) found.push({ ...old.touch, end: start });
        if (old) anew.set(pair, start);
        open2.set(pair, { touch, before: before2 });
      } else if (event.kind === "release" && !event.impulse) {
        open2.set(`loose ${pair}`, { touch: { ...touch, loose: true }, before: before2 });
      } else if (event.kind === "peak") {
        peaks.set(pair, event.t);
      } else if (event.kind === "separate" && anew.get(pair) === start) {
        anew.delete(pair);
      } else if (event.kind === "separate" || event.kind === "stick") {
        const keys2 = [`loose ${pair}`, pair].filter((key3) => open2.has(key3));
        const key2 = keys2.length < 2 || begunWith(before2, open2.get(String(keys2[0]))) ? keys2[0] : pair;
        const over2 = key2 && open2.get(key2);
        if (!over2) continue;
        open2.delete(key2);
        found.push({ ...over2.touch, end: event.t });
      }
    }
    for (const { touch } of open2.values()) {
      const peak = touch.loose ? until : peaks.get(touch.pair) ?? until;
      found.push({ ...touch, end: peak > touch.start ? peak : until, lasts: true });
    }
    return found.filter((touch) => touch.end > touch.start).sort((a, b) => a.start - b.start);
  }
  function begunWith(before2, one) {
    return Object.entries(one?.before ?? {}).every(([name, v]) => before2[name] === v);
  }
  var ROUNDED = 1 + 1e-9;
  var FELT = 0.1;
  function windowsOf({ header, trajectory }) {
    const found = touches(header.events, header.until);
    const { t, F } = trajectory;
    for (const event of header.events) {
      const pair = event.bodies.join("-");
      const column = F[pair];
      const within = found.some(
        (touch) => touch.pair === pair && touch.start <= event.t && event.t <= touch.end
      );
      if (event.kind !== "peak" || within || !column || t.length < 2) continue;
      const felt = (k) => Number(column[k]) > FELT * (event.force ?? 0);
      let [first, last] = [rowAt(t, event.t), rowAt(t, event.t)];
      while (first > 0 && felt(first)) first -= 1;
      while (last < t.length - 1 && felt(last)) last += 1;
      const window2 = { start: Number(t[first]), end: Number(t[last]) };
      found.push({ pair, bodies: event.bodies, ...window2, near: true });
    }
    for (const bodies of pairsApart(header)) {
      const pair = bodies.join("-");
      const end2 = letGo(t, F[pair] ?? []);
      const within = found.some((touch) => touch.pair === pair && touch.start <= 0);
      if (end2 && !within) found.push({ pair, bodies, start: 0, end: end2, near: true });
    }
    return found.sort((a, b) => a.start - b.start);
  }
  function letGo(t, force) {
    const first = Number(force[0]);
    for (let row2 = 1; row2 < force.length; row2 += 1) {
      const now = Number(force[row2]);
      if (now > first * ROUNDED) return 0;
      if (now < FELT * first) return Number(t[row2]);
    }
    return 0;
  }
  function latestTouch(windows, t) {
    return windows.findLast((touch) => touch.start <= t);
  }

  // src/shared/dom.js
  var SVG = "http://www.w3.org/2000/svg";
  function svg(tag, attributes2 = {}) {
    const made = document.createElementNS(SVG, tag);
    for (const [name, value] of Object.entries(attributes2)) made.setAttribute(name, String(value));
    return made;
  }
  function html2(tag, className = "", text3 = "") {
    const made = document.createElement(tag);
    if (className) made.className = className;
    if (text3) made.textContent = text3;
    return made;
  }
  function put(element, name, value) {
    if (element.getAttribute(name) !== value) element.setAttribute(name, value);
  }
  function fit(group, count, make) {
    while (group.children.length > count) group.lastElementChild?.remove();
    while (group.children.length < count) group.append(make());
  }
  var TEXT = 3;
  function say(element, text3) {
    const only = element.firstChild;
    if (only?.nodeType === TEXT && !only.nextSibling) {
      if (only.nodeValue !== text3) only.nodeValue = text3;
    } else if (element.textContent !== text3) element.textContent = text3;
  }
  function need(root, selector) {
    const found = root.querySelector(selector);
    if (!found) throw new Error(`this page lacks ${selector}; it was built by another version`);
    return found;
  }
  function onResize(element, act) {
    if (typeof ResizeObserver === "function") new ResizeObserver(act).observe(element);
  }

  // src/cost/stage.js
  var [WIDTH5, FLOOR_Y, SIDE] = [640, 84, 20];
  var [LOWEST, TALLEST2] = [16, 58];
  var ENERGY = { left: 60, top: 10, right: 388, bottom: 160 };
  var MOST = 3;
  function measureOf(exact) {
    const [start, most] = [Number(exact[0]), Math.max(...exact)];
    return inParts(start, most) ? { whole: start, unit: "%", ticked: 100 } : { whole: most || 1, unit: "J", ticked: most || 1 };
  }
  var CostStage = class {
    constructor(root) {
      this.stage = need(root, ".carts-cost-stage");
      this.energy = need(root, ".carts-cost-energy");
      this.carts = [];
      this.ghosts = [];
      this.cursor = null;
    }
    show(header, numbers) {
      this.header = header;
      const { rows, bodies } = header;
      const column = (k) => Array.from({ length: rows }, (_, row2) => Number(numbers[k * rows + row2]));
      this.t = column(0);
      const count = bodies.length;
      this.x = bodies.map((_, k) => column(1 + k));
      this.exact = bodies.map((_, k) => column(1 + count + k));
      this.#lay();
      this.#plot(column(1 + 2 * count), column(2 + 2 * count));
      this.at(0);
    }
    #lay() {
      const { bodies, track } = this.header;
      const paths = this.exact ?? [];
      const ends2 = bodies.flatMap(({ length }, k) => {
        const all = paths[k] ?? [0];
        return [Math.min(...all) - length, Math.max(...all) + length];
      });
      const left = track.left === "wall" ? 0 : Math.min(...ends2);
      const right = track.right === "wall" ? Number(track.length) : Math.max(...ends2);
      this.scale = (WIDTH5 - 2 * SIDE) / (right - left);
      this.left = left;
      const heaviest = Math.max(...bodies.map(({ mass }) => mass));
      const shape = (k, name) => {
        const { mass, length } = bodies[k];
        const height = LOWEST + (TALLEST2 - LOWEST) * mass / heaviest;
        const width = length * Number(this.scale);
        const box2 = {
          x: px(-width / 2),
          y: px(FLOOR_Y - height),
          width: px(width),
          height: px(height)
        };
        return svg("rect", { class: name, rx: 3, ...box2 });
      };
      const group = (k) => {
        const made = svg("g", { class: `carts-b${k % 8}` });
        const name = svg("text", { class: "carts-name", y: FLOOR_Y + 16, "text-anchor": "middle" });
        name.textContent = bodies[k]?.name ?? "";
        made.append(shape(k, "carts-box"), name);
        return made;
      };
      this.carts = bodies.map((_, k) => group(k));
      this.ghosts = bodies.map((_, k) => shape(k, `carts-cost-ghost carts-b${k % 8}`));
      const floor = svg("path", { class: "carts-rule", d: `M0 ${FLOOR_Y}H${WIDTH5}` });
      const walls = [];
      if (track.left === "wall") walls.push(this.#place(0));
      if (track.right === "wall") walls.push(this.#place(Number(track.length)));
      this.stage.replaceChildren(
        floor,
        ...walls.map((x) => svg("path", { class: "carts-wall-face", d: `M${px(x)} 14V${FLOOR_Y}` })),
        ...this.carts,
        ...this.ghosts
      );
    }
    #place(x) {
      return SIDE + (x - Number(this.left)) * Number(this.scale);
    }
    #plot(stepped, exact) {
      const { until } = this.header;
      const { whole, unit, ticked } = measureOf(exact);
      const { left, top, right, bottom } = ENERGY;
      const finite = stepped.map((value) => Number.isFinite(value) ? value / whole : MOST);
      const high = Math.min(MOST, Math.max(1, ...finite, ...exact.map((value) => value / whole)));
      const scale = axis(0, ticked * high, 4);
      const y = (part) => bottom - ticked * Math.min(part, high) / scale.high * (bottom - top);
      const x = (t) => left + t / until * (right - left);
      const path3 = (values) => values.map((value, k) => `${k ? "L" : "M"}${px(x(Number(this.t?.[k])))} ${px(y(value))}`).join("");
      const parts2 = ticks2(scale).filter((tick) => tick >= 0).flatMap((tick) => {
        const label = svg("text", {
          class: "carts-tick-y",
          x: left - 6,
          y: px(y(tick / ticked) + 4)
        });
        label.textContent = `${short(tick)} ${unit}`;
        return [
          svg("path", { class: "carts-grid", d: `M${left} ${px(y(tick / ticked))}H${right}` }),
          label
        ];
      });
      const last = svg("text", { class: "carts-tick-x", x: right, y: bottom + 20 });
      last.textContent = `${short(until)} s`;
      const first = svg("text", { class: "carts-tick-x", x: left, y: bottom + 20 });
      first.textContent = "0";
      this.cursor = svg("path", { class: "carts-cost-cursor" });
      this.energy.replaceChildren(
        ...parts2,
        first,
        last,
        svg("path", {
          class: "carts-cost-line carts-cost-true",
          d: path3(exact.map((e) => e / whole))
        }),
        svg("path", { class: "carts-cost-line carts-cost-made", d: path3(finite) }),
        this.cursor
      );
    }
    at(time) {
      const times2 = this.t ?? [];
      let k = times2.findLastIndex((t) => t <= time);
      k = Math.min(Math.max(k, 0), Math.max(0, times2.length - 2));
      const [a, b] = [Number(times2[k]), Number(times2[k + 1])];
      const part = b > a ? Math.min(1, (time - a) / (b - a)) : 0;
      const between2 = (xs) => {
        const here = Number(xs?.[k]);
        const x2 = this.#place(here + part * (Number(xs?.[k + 1] ?? here) - here));
        return Number.isFinite(x2) ? Math.min(5e3, Math.max(-5e3, x2)) : 5e3;
      };
      for (const [cart2, shape] of this.carts.entries()) {
        put(shape, "transform", `translate(${px(between2(this.x?.[cart2]), 2)} 0)`);
      }
      for (const [cart2, shape] of this.ghosts.entries()) {
        put(shape, "transform", `translate(${px(between2(this.exact?.[cart2]), 2)} 0)`);
      }
      const { left, top, right, bottom } = ENERGY;
      const x = left + time / Number(this.header?.until ?? 1) * (right - left);
      if (this.cursor) put(this.cursor, "d", `M${px(x)} ${top}V${bottom}`);
    }
  };

  // src/measured/figure.js
  var [LEFT6, RIGHT5, TOP6, BOTTOM6] = [78, 630, 10, 250];
  var LOW = { top: 8, bottom: 104 };
  var ROOM2 = 0.06;
  var HEAD = 1.15;
  function reach(lists) {
    let [low, high] = [Infinity, -Infinity];
    for (const list of lists) {
      for (const value of list) {
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
    return [low, high];
  }
  var across2 = (axis2, value) => LEFT6 + (value - axis2.low) / (axis2.high - axis2.low) * (RIGHT5 - LEFT6);
  var up2 = (axis2, value, top = TOP6, bottom = BOTTOM6) => bottom - (value - axis2.low) / (axis2.high - axis2.low) * (bottom - top);
  function planes(tracks) {
    const [begin, end2] = reach(tracks.map((track) => track.t));
    const [low, high] = reach(tracks.map((track) => track.value));
    const room = ROOM2 * (high - low) || 1;
    return { t: span(begin, end2, 8), x: span(low - room, high + room, 8) };
  }
  var DOT2 = "h0.01";
  function dots(t, values, axis2, up_, room = [TOP6, BOTTOM6]) {
    return t.map((time, k) => `M${px(across2(axis2, time))} ${px(up2(up_, Number(values[k]), ...room))}${DOT2}`).join("");
  }
  var Figure = class {
    #cursor = null;
    #axis = null;
    constructor(place2, left) {
      this.place = place2;
      this.left = left;
    }
    show(tracks, heads2, curve3, touch = null) {
      const { t, x } = planes(tracks);
      this.#axis = t;
      this.#cursor = svg("path", { class: "carts-measured-cursor" });
      this.place.replaceChildren(
        ...frame2(t, x, BOTTOM6, TOP6, heads2),
        ...touch === null ? [] : band2(t, touch, TOP6, BOTTOM6),
        ...tracks.map(
          (track, k) => svg("path", {
            class: `carts-measured-dots carts-b${k}`,
            d: dots(track.t, track.value, t, x)
          })
        ),
        model2(curve3, t, x),
        this.#cursor
      );
    }
    rest(tracks, residuals, unit, factor) {
      const { t } = planes(tracks);
      const [low, high] = reach(residuals);
      const most = HEAD * factor * Math.max(1e-12, -low, high);
      const axis2 = span(-most, most, 6);
      this.left.toggleAttribute("hidden", false);
      this.left.replaceChildren(
        ...frame2(t, axis2, LOW.bottom, LOW.top, { value: unit }),
        svg("path", {
          class: "carts-measured-zero",
          d: `M${LEFT6} ${px(up2(axis2, 0, LOW.top, LOW.bottom))}H${RIGHT5}`
        }),
        ...tracks.map(
          (track, k) => svg("path", {
            class: `carts-measured-dots carts-measured-small carts-${tracks.length > 1 ? `b${k}` : "total"}`,
            d: dots(
              track.t,
              (residuals[k] ?? []).map((value) => factor * value),
              t,
              axis2,
              [LOW.top, LOW.bottom]
            )
          })
        )
      );
    }
    at(time) {
      if (!this.#cursor || !this.#axis) return;
      put(this.#cursor, "d", `M${px(across2(this.#axis, time))} ${TOP6}V${BOTTOM6}`);
    }
  };
  function model2(curve3, t, x) {
    const [width, height] = [RIGHT5 - LEFT6, BOTTOM6 - TOP6];
    const room = svg("svg", { x: LEFT6, y: TOP6, width, height });
    put(room, "viewBox", `${LEFT6} ${TOP6} ${width} ${height}`);
    const at = (n) => px(across2(t, Number(curve3?.t[n])));
    for (const [k, values] of (curve3?.x ?? []).entries()) {
      const d = values.map((value, n) => `${n ? "L" : "M"}${at(n)} ${px(up2(x, value))}`).join("");
      room.append(svg("path", { class: `carts-measured-curve carts-b${k}`, d }));
    }
    return room;
  }
  function band2(t, touch, top, bottom) {
    if (touch < t.low || touch > t.high) return [];
    return [
      svg("path", {
        class: "carts-measured-touch",
        d: `M${px(across2(t, touch))} ${top}V${bottom}`
      })
    ];
  }
  function frame2(t, x, bottom, top, { time, value }) {
    const parts2 = [];
    for (const tick of ticks2(t)) {
      const at = px(across2(t, tick));
      parts2.push(svg("path", { class: "carts-grid", d: `M${at} ${top}V${bottom}` }));
      parts2.push(text2("carts-tick-x", at, bottom + 16, fixed(tick, axisDecimals(t))));
    }
    for (const tick of ticks2(x)) {
      const at = px(up2(x, tick, top, bottom));
      parts2.push(svg("path", { class: "carts-grid", d: `M${LEFT6} ${at}H${RIGHT5}` }));
      parts2.push(text2("carts-tick-y", LEFT6 - 6, Number(at) + 4, fixed(tick, axisDecimals(x))));
    }
    const label = svg("text", {
      class: "carts-unit",
      transform: `translate(18 ${(top + bottom) / 2}) rotate(-90)`,
      "text-anchor": "middle"
    });
    label.textContent = value;
    parts2.push(label);
    if (time) {
      const name = text2("carts-unit", RIGHT5, bottom + 31, time);
      put(name, "text-anchor", "end");
      parts2.push(name);
    }
    return parts2;
  }
  function text2(name, x, y, words) {
    const made = svg("text", { class: name, x, y });
    made.textContent = words;
    return made;
  }

  // src/scene/baked.js
  function bakedOf({ fence, view, numbers, ...header }) {
    const known2 = header;
    return { fence, view, run: { header: known2, trajectory: fromBaked(numbers, known2.events) } };
  }

  // ../view/series.js
  function seriesOf(quantity, header, run, camera, signed = false, per = 1) {
    if (quantity === "F") return forces(header, run, signed);
    if (quantity === "R") return resultants(header, run);
    const times2 = Float64Array.from(run.t);
    const curves = header.bodies.map((body2, i) => {
      const { name, mass } = body2;
      const [x, v, a] = [run.x[name] ?? [], run.v[name] ?? [], run.a[name] ?? []];
      const seen = Float64Array.from(v, (speed) => speed - camera);
      const curve3 = { label: name, style: styleOf(i), over: false };
      switch (quantity) {
        case "x": {
          const values = Float64Array.from(x, (place2, k) => place2 - camera * Number(times2[k]));
          return { ...curve3, values, slopes: seen };
        }
        case "v":
          return {
            ...curve3,
            values: seen.map((speed) => speed / per),
            slopes: Float64Array.from(a, (rate) => rate / per)
          };
        case "a":
          return { ...curve3, values: a, slopes: jerk(header, run, body2, 1 / mass) };
        case "p":
          return {
            ...curve3,
            values: seen.map((speed) => mass * speed),
            slopes: Float64Array.from(a, (value) => mass * value)
          };
        default:
          return {
            ...curve3,
            values: seen.map((speed) => mass * speed * speed / 2),
            slopes: Float64Array.from(a, (rate, k) => mass * Number(seen[k]) * rate)
          };
      }
    });
    if (quantity === "p" && outside(header)) curves.push(partner(curves, outside(header)));
    if ((quantity === "p" || quantity === "energy") && curves.length > 1) curves.push(total(curves));
    return curves;
  }
  function resultants(header, run) {
    return header.bodies.flatMap((body2, i) => {
      const { name, mass } = body2;
      const style = styleOf(i);
      const values = Float64Array.from(run.a[name] ?? [], (rate) => mass * rate);
      const parts2 = partsOf(header, run, name).map(({ by, column }) => ({
        label: tr("on {on} by {by}", { on: body(name, header.track), by }),
        style,
        over: true,
        values: column,
        slopes: null
      }));
      const slopes = jerk(header, run, body2, 1);
      return [{ label: name, style, over: false, values, slopes }, ...parts2];
    });
  }
  function jerk(header, run, { name }, per) {
    if (header.effects.some(({ active, carts }) => active && carts.includes(name))) return null;
    const found = new Float64Array(run.t.length);
    for (const { pair, bodies } of header.contacts) {
      const column = bodies.includes(name) ? run.dF[pair] : null;
      const sign = bodies[0] === name ? -per : per;
      for (let k = 0; column && k < found.length; k += 1) {
        found[k] = Number(found[k]) + sign * Number(column[k]);
      }
    }
    return found;
  }
  function partner(curves, label) {
    const { values, slopes } = total(curves);
    const start = Number(values[0]);
    return {
      label,
      style: "wall",
      over: false,
      values: Float64Array.from(values, (value) => start - value),
      slopes: slopes && Float64Array.from(slopes, (slope) => -slope)
    };
  }
  function total(curves) {
    const sum = (columns) => {
      const rows = Float64Array.from(columns[0] ?? []);
      for (const column of columns.slice(1)) {
        for (let k = 0; k < rows.length; k += 1) rows[k] = Number(rows[k]) + Number(column?.[k]);
      }
      return rows;
    };
    return {
      label: curves.some(({ style }) => style === "wall") ? tr("all together") : tr("all carts"),
      style: "total",
      over: false,
      values: sum(curves.map((c) => c.values)),
      slopes: curves.every((c) => c.slopes) ? sum(curves.map((c) => c.slopes)) : null
    };
  }
  function forces(header, run, signed) {
    const styles = new Map(header.bodies.map((body2, i) => [body2.name, styleOf(i)]));
    const sign = signed ? -1 : 1;
    const curves = [];
    for (const contact of header.contacts) {
      let force = run.F[contact.pair];
      let slope = run.dF[contact.pair];
      if (!force || !slope || !Array.prototype.some.call(force, (f) => f !== 0)) continue;
      if (!signed) {
        const pulls = Array.from(force, (f) => f < 0);
        slope = Float64Array.from(slope, (s, k) => pulls[k] ? -s : s);
        force = Float64Array.from(force, Math.abs);
      }
      const [left, right] = contact.bodies;
      curves.push({
        label: onBy(left, right, header.track),
        style: styles.get(left) ?? "wall",
        over: false,
        values: Float64Array.from(force, (f) => sign * f),
        slopes: Float64Array.from(slope, (s) => sign * s)
      });
      curves.push({
        label: onBy(right, left, header.track),
        style: styles.get(right) ?? "wall",
        over: true,
        values: force,
        slopes: slope
      });
    }
    return curves;
  }

  // src/scene/beside/bars.js
  var HALF2 = 60;
  var Bars = class {
    #run = null;
    #curves = [];
    #windows = [];
    #full = 1;
    #first = 0;
    // of the lesson's own run, so that runs can be compared
    constructor(root, baked) {
      this.root = root;
      this.camera = baked.fence.camera;
      this.decimals = baked.view.decimals.p ?? 2;
      this.rows = root.querySelectorAll("tbody tr");
      this.since = need(root, ".carts-touch-note");
    }
    show(run, windows) {
      this.#run = run;
      this.#windows = windows.filter(({ near: near2 }) => !near2);
      this.#curves = seriesOf("p", run.header, run.trajectory, this.camera);
      let most = this.#first;
      for (const { values } of this.#curves) {
        for (let k = 0; k < values.length; k += 1) most = Math.max(most, Math.abs(Number(values[k])));
      }
      if (!this.#first) this.#first = most;
      this.#full = most || 1;
    }
    at(t) {
      const run = this.#run;
      if (!run) return;
      const start = latestTouch(this.#windows, t)?.start ?? 0;
      say(this.since, tr("at {time} s", { time: fixed(start, 2) }));
      this.rows.forEach((row2, k) => {
        const curve3 = this.#curves[k];
        row2.hidden = !curve3;
        if (!curve3) return;
        const at = (when) => {
          const value = valueAt2(run.trajectory.t, curve3.values, curve3.slopes, when);
          return Math.abs(value) < NOISE * this.#full ? 0 : value;
        };
        const [before2, now] = [at(start), at(t)];
        say(need(row2, "th"), curve3.label);
        const texts = [before2, now, now - before2].map((value) => fixed(value, this.decimals));
        row2.querySelectorAll("td[data-when]").forEach((cell2, i) => {
          say(cell2, texts[i] ?? "");
        });
        bar2(need(row2, '[data-part="before"]'), before2 / this.#full);
        bar2(need(row2, '[data-part="now"]'), now / this.#full);
      });
    }
  };
  function bar2(rect, part) {
    const length = HALF2 * Math.min(1, Math.abs(part));
    put(rect, "x", px(part < 0 ? HALF2 + 4 - length : HALF2 + 4));
    put(rect, "width", px(length));
  }

  // src/scene/beside/free-body.js
  var WIDTH6 = 260;
  var HEIGHT5 = 60;
  var BOX = { left: 20, right: 240, top: 8, bottom: 52 };
  var AXIS = 38;
  var MIDDLE2 = WIDTH6 / 2;
  var APART2 = 8;
  var FULL2 = 95;
  var FreeBody = class {
    #run = null;
    #windows = [];
    #vertical = false;
    constructor(root, baked, redraw) {
      this.root = root;
      this.view = baked.view;
      this.per = speedUnit(baked.view.velocity)[0];
      this.zero = NOISE * (baked.view.force || 1);
      this.note = need(root, ".carts-touch-note");
      const vertical = need(root, ".carts-vertical");
      vertical.addEventListener("change", () => {
        this.#vertical = vertical.checked;
        this.root.classList.toggle("carts-with-vertical", vertical.checked);
        redraw();
      });
    }
    show(run, windows) {
      this.#run = run;
      say(need(this.root, ".carts-vertical-note"), verticalNote(run.header));
      this.#windows = windows.filter(({ near: near2 }) => !near2);
    }
    at(t) {
      const run = this.#run;
      if (!run) return;
      const touch = latestTouch(this.#windows, t);
      const since = touch && tr("since the touch at {time} s", { time: fixed(touch.start, 2) });
      say(this.note, since || tr("since the start"));
      const room = this.#vertical ? this.#roomFor(run) : 0;
      for (const { name, mass } of run.header.bodies) {
        const along = forcesAlong(run, name, t, this.zero);
        this.#draw(name, this.#vertical ? [...along, ...verticalForces(run, name)] : along, room);
        const whole = summed(along);
        const { t: times2, v, a } = run.trajectory;
        const speed = (at) => valueAt2(times2, v[name] ?? [], a[name] ?? [], at);
        const change = speed(t) - speed(touch?.start ?? 0);
        const { decimals, velocity: velocity2 } = this.view;
        const seen = Math.abs(change) < NOISE * velocity2 ? 0 : change / this.per;
        this.#say(name, "F", fixed(whole, decimals.F ?? 2));
        this.#say(name, "mass", short(mass));
        this.#say(name, "a", fixed(whole / mass, decimals.a ?? 2));
        this.#say(name, "dv", fixed(seen, decimals.v ?? 2));
      }
    }
    #say(name, quantity, text3) {
      const cell2 = this.root.querySelector(`td[data-body="${name}"][data-quantity="${quantity}"]`);
      if (cell2) say(cell2, text3);
    }
    #roomFor({ header }) {
      const weights = header.bodies.map(({ mass }) => mass * header.gravity);
      const longest = arrowLength(Math.max(...weights), this.view.force, FULL2);
      return Math.ceil(Math.max(0, longest - (BOX.bottom - BOX.top) / 2) + 6);
    }
    #draw(name, forces2, room) {
      const card = need(this.root, `.carts-alone[data-body="${name}"]`);
      const group = need(card, '[data-part="forces"]');
      const list = need(card, "ul");
      while (group.children.length < forces2.length) group.append(svg("path"));
      while (group.children.length > forces2.length) group.lastElementChild?.remove();
      while (list.children.length < forces2.length) list.append(document.createElement("li"));
      while (list.children.length > forces2.length) list.lastElementChild?.remove();
      forces2.forEach((force, k) => {
        const length = arrowLength(force.value, this.view.force, FULL2);
        const cut = isCut(force.value, this.view.force);
        const path3 = group.children[k];
        const [x, y] = tail2(force);
        put(path3, "class", "carts-block-arrow");
        put(path3, "d", (cut ? cutArrow : blockArrow)(x, y, length));
        put(path3, "transform", force.way === "up" ? `rotate(-90 ${px(x)} ${px(y)})` : "");
        say(list.children[k], this.#sentence(force, cut));
      });
      const picture2 = need(card, "svg");
      put(picture2, "viewBox", `0 ${-room} ${WIDTH6} ${HEIGHT5 + 2 * room}`);
      put(picture2, "height", String(HEIGHT5 + 2 * room));
    }
    #sentence({ name, way, value, size: written }, cut) {
      const size = `${written ?? fixed(Math.abs(value), this.view.decimals.F ?? 2)} N`;
      const told3 = { name, size };
      const ways = way === "up" ? [tr("{name}: {size} down", told3), tr("{name}: {size} up", told3)] : [tr("{name}: {size} to the left", told3), tr("{name}: {size} to the right", told3)];
      const said = value === 0 ? `${name}: ${size}` : ways[value < 0 ? 0 : 1];
      return `${said}${cut ? tr(", arrow cut") : ""}`;
    }
  };
  function tail2({ way, side: side2, value }) {
    if (way === "up") {
      const middle = (BOX.top + BOX.bottom) / 2;
      return value < 0 ? [MIDDLE2 - APART2, middle] : [MIDDLE2 + APART2, BOX.bottom];
    }
    if (side2 === "middle") return [MIDDLE2, AXIS];
    if (side2 === "below") return [MIDDLE2, BOX.bottom];
    if (side2 === "above") return [MIDDLE2, BOX.top];
    return [side2 === "left" ? BOX.left : BOX.right, AXIS];
  }

  // ../view/deformation/bubbles.js
  var APART3 = 13;
  var RADIUS = 3.5;
  var SMALL = 0.6;
  function bubbles(front, back, depth, [top, foot], size = 1) {
    const columns = Math.max(2, Math.round(depth / (APART3 * size)));
    const rows = Math.max(2, Math.floor((foot - top) / (APART3 * size)));
    let d = "";
    for (let row2 = 0; row2 < rows; row2 += 1) {
      const y = top + (row2 + 0.5) * (foot - top) / rows;
      const room = back - front(y);
      const squeezed = Math.min(1, Math.abs(room) / depth);
      for (let column = 0; column < columns; column += 1) {
        const x = front(y) + room * (column + (row2 % 2 ? 0.7 : 0.3)) / columns;
        d += bubble(x, y, size * RADIUS * ((row2 + column) % 3 ? 1 : SMALL), squeezed);
      }
    }
    return d;
  }
  function bubble(x, y, radius, squeezed) {
    const wide = px(radius * squeezed);
    const across3 = px(2 * radius * squeezed);
    const half = `a${wide} ${px(radius)} 0 1 0`;
    return `M${px(x - Number(wide))} ${px(y)}${half} ${across3} 0${half} -${across3} 0`;
  }

  // ../view/deformation/walls.js
  var LEAST = 64;
  var THICK = 2e3;
  var ROOM3 = 3;
  var SEEN = 1;
  function wallAt(side2, length, layout, tallest) {
    const x = side2 === "left" ? 0 : Number(length);
    const edge3 = layout.origin + x * layout.scale;
    return { edge: edge3, way: side2 === "left" ? -1 : 1, top: layout.track - Math.max(tallest, LEAST) };
  }
  function wallPaths({ edge: edge3, way, top }, { track, beam }, dent, height) {
    const high = Math.max(top, track - height - ROOM3);
    const shoulder = Math.max(top, high - dent);
    const pressed2 = `V${px(shoulder)}L${px(edge3 + way * dent)} ${px(high)}V${px(track)}H${px(edge3)}`;
    const face2 = `M${px(edge3)} ${px(top)}${dent > 0 ? pressed2 : ""}V${px(track + beam)}`;
    const was = dent < SEEN ? "" : `M${px(edge3)} ${px(shoulder)}V${px(track)}`;
    return { body: `${face2}h${way * THICK}V${px(top)}Z`, face: face2, was };
  }

  // ../view/deformation/things.js
  var SHARE = 0.5;
  var LEAST2 = 30;
  var MOST2 = 60;
  var SHALLOW = 0.6;
  var SOLID = 8;
  var ARM = 12;
  var PLATE = 4;
  var PLANK = 8;
  var PITCH = 9;
  var HIGH2 = 13;
  var MADE2 = {
    foam(place2) {
      const { x, heights, back, depth } = place2;
      const [top, foot] = endsOf(heights);
      const above = `M${px(x(top))} ${px(top)}H${px(back)}`;
      const inside7 = bubbles(x, back, depth, [top, foot]);
      return { own: [...face(place2), [back, foot], [back, top]], lines: above + inside7 };
    },
    spring(place2) {
      const { x, heights, back, depth } = place2;
      const [top, foot] = endsOf(heights);
      const [from, to] = [x(top, PLATE), back].sort((a, b) => a - b);
      const turns = Math.round(depth / PITCH);
      const wire = coil(Number(from), Number(to), (top + foot) / 2, turns, HIGH2);
      const plate = slab(place2, PLATE);
      return { own: plate, lines: area(plate) + wire };
    },
    board(place2) {
      const plank = slab(place2, PLANK);
      return { own: plank, lines: area(plank) + line(face(place2, PLANK / 2)) };
    }
  };
  function depthOf(what, { edge: edge3, way }, { width }) {
    const beyond = way > 0 ? width - edge3 : edge3;
    const depth = Math.max(LEAST2, Math.min(MOST2, SHARE * beyond));
    return what === "board" ? SHALLOW * depth : depth;
  }
  function thingPaths(what, wall, layout, dent, height) {
    const place2 = pressed(what, wall, layout, dent, height);
    const { own, lines: lines3 } = MADE2[what](place2);
    const inner = mounting(what, wall, layout, place2.back);
    const far = wall.edge + wall.way * THICK;
    const behind = area([...inner, [far, wall.top], [far, layout.track + layout.beam]]);
    const [begin = 0] = place2.heights.slice(-3);
    return {
      body: behind + area(own),
      hatch: behind,
      face: line(face(place2)) + line(inner),
      was: dent < SEEN ? "" : `M${px(wall.edge)} ${px(begin)}V${px(layout.track)}`,
      lines: lines3
    };
  }
  function pressed(what, wall, layout, dent, height) {
    const { edge: edge3, way, top } = wall;
    const foot = layout.track;
    const depth = depthOf(what, wall, layout);
    const back = edge3 + way * Math.max(depth, dent + SOLID);
    const place2 = (heights, give) => ({
      x: (y, behind = 0) => edge3 + way * (give(y) + behind),
      heights,
      back,
      depth
    });
    if (what === "spring" || dent === 0) return place2([top, foot], () => dent);
    const high = Math.max(top, foot - height - ROOM3);
    const shoulder = Math.max(top, Math.min(high, what === "board" ? top + ARM : high - dent));
    const part = (y) => y < high ? (y - shoulder) / (high - shoulder) : 1;
    return place2([top, shoulder, high, foot], (y) => dent * Math.max(0, part(y)));
  }
  function mounting(what, { edge: edge3, way, top }, { track, beam }, back) {
    const held = edge3 + way * PLANK;
    const arm = what === "board" ? [
      [back, top + ARM],
      [held, top + ARM],
      [held, top]
    ] : [[back, top]];
    return [[edge3, track + beam], [edge3, track], [back, track], ...arm];
  }
  function endsOf(heights) {
    return [Math.min(...heights), Math.max(...heights)];
  }
  function face({ x, heights }, behind = 0) {
    return heights.map((y) => [x(y, behind), y]);
  }
  function slab(place2, thick) {
    return [...face(place2), ...face(place2, thick).reverse()];
  }
  function line(points) {
    return `M${points.map(([x, y]) => `${px(x)} ${px(y)}`).join("L")}`;
  }
  function area(points) {
    return `${line(points)}Z`;
  }

  // src/scene/beside/lens-thing.js
  var TOP7 = 22;
  var FOOT = 88;
  var ARM2 = 12;
  var THICK2 = { spring: 12, board: 24 };
  var SOLID2 = 12;
  var FAR = 720;
  var PITCH2 = 16;
  var HIGH3 = 20;
  var BUBBLE = 1.4;
  function drawThing(group, what, thing) {
    const rect = need(group, '[data-part="body"]');
    const parts2 = ["mounting", "thing"].map((name) => group.querySelector(`[data-part="${name}"]`));
    if (what === "wall") {
      for (const part of parts2) part?.remove();
      put(rect, "width", String(FAR));
      return;
    }
    const [mounting2, lines3] = parts2[0] && parts2[1] ? parts2 : added(rect);
    const { end: end2, was, out, depth } = thing;
    const back = was + out * Math.max(depth, Math.abs(end2 - was) + (THICK2[what] ?? 0) + SOLID2);
    const thick = THICK2[what] ?? Math.abs(back - end2);
    put(rect, "x", px(out > 0 ? end2 : end2 - thick));
    put(rect, "width", px(thick));
    const behind = end2 + out * thick;
    const from = what === "board" ? `M${px(back)} ${TOP7 + ARM2}H${px(behind)}V${TOP7}` : `M${px(back)} ${TOP7}`;
    put(mounting2, "d", `${from}h${out * FAR}V${FOOT}H${px(back)}Z`);
    put(lines3, "class", what === "spring" ? "carts-coil" : "carts-fine");
    put(lines3, "d", inside6(what, { ...thing, back, behind }));
  }
  function inside6(what, { end: end2, depth, back, behind }) {
    if (what === "board") return `M${px((end2 + behind) / 2)} ${TOP7}V${FOOT}`;
    if (what === "foam") return bubbles(() => end2, back, depth, [TOP7, FOOT], BUBBLE);
    const [low, high] = [Math.min(behind, back), Math.max(behind, back)];
    return coil(low, high, (TOP7 + FOOT) / 2, Math.round(depth / PITCH2), HIGH3);
  }
  function added(rect) {
    const mounting2 = svg("path", { "data-part": "mounting", class: "carts-box" });
    const lines3 = svg("path", { "data-part": "thing" });
    rect.after(mounting2, lines3);
    return [mounting2, lines3];
  }

  // src/scene/beside/lens.js
  var TIMES3 = [10, 5, 2, 1];
  var MARGIN = 16;
  var WIDTH7 = 360;
  var TRACK = 96;
  var BAR = 70;
  var NAME = 42;
  var ABOVE3 = 16;
  var SCALE = 3;
  var Lens = class {
    #run = null;
    #windows = [];
    #perMetre = 3e3;
    // units
    #picture = 300;
    // units that one metre would take as large as in the picture
    #perForce = 100;
    // units of the full scale
    #t = 0;
    constructor(root, baked, redraw) {
      this.root = root;
      this.view = baked.view;
      [this.layout] = baked.view.layouts;
      this.scene = root.closest("carts-scene");
      this.plot = need(root, "svg");
      this.note = need(root, ".carts-lens-note");
      onResize(root, () => {
        this.#measure();
        redraw();
      });
    }
    #measure() {
      for (const layout of this.view.layouts) {
        const stage2 = this.scene.querySelector(`.carts-stage-${layout.kind}`);
        const [shown2, own] = [stage2?.clientWidth ?? 0, this.plot.clientWidth];
        if (!shown2 || !own) continue;
        const unit = shown2 / layout.width * (WIDTH7 / own);
        this.layout = layout;
        this.#picture = layout.scale * unit;
        this.#perForce = layout.force * unit;
      }
      this.#enlarge();
    }
    #enlarge() {
      const give = Math.max(this.view.gives, this.#run ? wallGives(this.#run) : 0);
      const room = WIDTH7 / 2 - MARGIN;
      const times2 = TIMES3.find((one) => give * one * this.#picture <= room) ?? 1;
      this.#perMetre = times2 * this.#picture;
      say(need(this.root, ".carts-heading"), tr("Lens on the contact, ×{times}", { times: times2 }));
      const length = niceAbove(BAR / this.#perMetre / 2.5);
      const bar3 = px(length * this.#perMetre);
      put(need(this.root, '[data-part="bar"]'), "d", `M10 16v-5m0 2.5h${bar3}m0 -2.5v5`);
      const text3 = need(this.root, '[data-part="bar-text"]');
      put(text3, "x", px(Number(bar3) + 16));
      say(text3, length < 0.01 ? `${short(length * 1e3)} mm` : `${short(length * 100)} cm`);
    }
    show(run, windows) {
      this.#run = run;
      this.#windows = windows;
      this.#enlarge();
    }
    at(t) {
      const run = this.#run;
      const coming = this.#windows.find(({ end: end2 }) => t <= end2);
      const past = latestTouch(this.#windows, t);
      const touch = coming ?? past;
      put(this.plot, "visibility", touch ? "visible" : "hidden");
      this.root.classList.toggle(
        "carts-is-slow",
        Boolean(touch && t >= touch.start && t <= touch.end)
      );
      if (!run || !touch) return say(this.note, tr("Nothing touches in this run."));
      this.#t = t;
      const faces = [this.#side(run, touch, 0).face, this.#side(run, touch, 1).face];
      const out = (Number(faces[1]) - Number(faces[0])) * this.#perMetre > WIDTH7;
      const over2 = past && t > past.end && (out || t >= run.header.until);
      say(need(this.root, '[data-part="when"]'), over2 ? tr("when they pushed hardest") : "");
      if (over2) this.#t = hardest(run, past);
      this.#show(run, over2 ? past : touch);
    }
    #show(run, touch) {
      const t = this.#t;
      const [left, right] = [this.#side(run, touch, 0), this.#side(run, touch, 1)];
      const overlap = Math.max(0, left.face - right.face);
      const give = Math.min(overlap, left.bumper + right.bumper);
      const share = Math.min(left.bumper, left.bumper && right.bumper ? give / 2 : give);
      const touched = isWall(left.name) ? right.face + give : left.face - share;
      const middle = overlap > 0 ? touched : (left.face + right.face) / 2;
      const faces = overlap > 0 ? [touched, touched] : [left.face, right.face];
      const force = contactForce(run, touch.pair, t, NOISE * (this.view.force || 1));
      [left, right].forEach((side2, k) => {
        this.#draw(run, k, side2, Number(faces[k]), middle, force);
      });
      const pushed = touch.loose && t >= touch.start && t <= touch.end;
      const at = (x) => WIDTH7 / 2 + (x - middle) * this.#perMetre;
      const wall = [left, right].find(({ name }) => isWall(name));
      const was = wall && overlap > 0 ? `M${px(at(wall.face))} 22V${TRACK}` : "";
      put(need(this.root, '[data-part="was"]'), "d", was);
      const wire = coil(at(left.face), at(right.face), TRACK - 14, void 0, 6);
      put(need(this.root, '[data-part="between"]'), "d", pushed ? wire : "");
      const pair = bodiesOf(touch.bodies, run.header.track);
      const gap = right.face - left.face;
      const apart = gap > 0 ? tr("{length} apart", { length: lengthText(gap) }) : tr("squeezed by {length}", { length: lengthText(overlap) });
      const size = fixed(force, this.view.decimals.F ?? 2);
      const push2 = tr("{size} on each", { size: `${size} N` });
      say(this.note, `${pair}: ${apart}, ${push2}; t = ${fixed(t, 4)} s`);
    }
    #side({ header, trajectory }, touch, k) {
      const name = String(touch.bodies[k]);
      const cart2 = header.bodies.find((one) => one.name === name);
      if (!cart2) {
        const wall = name === "left" ? 0 : header.track.length ?? 0;
        return { name, edge: wall, face: wall, bumper: 0 };
      }
      const { t, x, v } = trajectory;
      const centre = valueAt2(t, x[name] ?? [], v[name] ?? [], this.#t);
      const way = k === 0 ? 1 : -1;
      const face2 = centre + way * cart2.length / 2;
      return { name, face: face2, edge: face2 - way * cart2.bumper_length, bumper: cart2.bumper_length };
    }
    #draw(run, k, side2, face2, middle, force) {
      const at = (x) => WIDTH7 / 2 + (x - middle) * this.#perMetre;
      const group = need(this.root, `[data-side="${k}"]`);
      const { bodies, track } = run.header;
      const index2 = bodies.findIndex(({ name: name2 }) => name2 === side2.name);
      put(group, "class", index2 < 0 ? "carts-wall" : `carts-b${index2 % 8}`);
      const way = k === 0 ? 1 : -1;
      const end2 = at(face2);
      const edge3 = index2 < 0 ? end2 : at(side2.edge);
      const rect = need(group, '[data-part="body"]');
      put(rect, "x", px(k === 0 ? edge3 - 2 * WIDTH7 : edge3));
      const what = index2 < 0 ? whatIs(side2.name, track) : "wall";
      const depth = this.#depth(side2.name, what, track.length);
      drawThing(group, what, { end: end2, was: at(side2.face), out: way > 0 ? -1 : 1, depth });
      const bent = need(group, '[data-part="spring"]');
      put(bent, "d", side2.bumper ? spring(edge3 / SCALE, end2 / SCALE) : "");
      put(bent, "transform", `translate(0 ${TRACK}) scale(${SCALE})`);
      const plate = need(group, '[data-part="face"]');
      put(plate, "transform", `translate(${px(end2 - 3 * way)} 0)`);
      const name = need(group, '[data-part="name"]');
      const inside7 = Math.min(WIDTH7 - 34, Math.max(34, edge3 - 22 * way));
      put(name, "x", px(inside7));
      put(name, "y", String(what === "wall" ? NAME : ABOVE3));
      say(name, index2 < 0 ? kind(side2.name, track) : side2.name);
      const arrow = need(group, '[data-part="arrow"]');
      const cut = isCut(force, this.view.force);
      const length = -way * arrowLength(force, this.view.force, this.#perForce);
      put(arrow, "d", (cut ? cutArrow : blockArrow)(end2, TRACK - 46, length));
    }
    #depth(side2, what, length) {
      if (!this.layout || what === "wall") return 0;
      const wall = wallAt(side2 === "left" ? "left" : "right", length, this.layout, 0);
      return depthOf(what, wall, this.layout) / this.layout.scale * this.#perMetre;
    }
  };
  function hardest({ header }, { pair, start, end: end2 }) {
    const peak = header.events.find(
      (one) => one.kind === "peak" && one.bodies.join("-") === pair && one.t >= start && one.t <= end2
    );
    return peak?.t ?? start;
  }
  function wallGives({ header: { bodies, track }, trajectory: { x } }) {
    const ends2 = [
      { wall: track.left, at: 0, cart: bodies[0], way: -1 },
      { wall: track.right, at: track.length ?? 0, cart: bodies.at(-1), way: 1 }
    ];
    const gives = ends2.map(({ wall, at, cart: cart2, way }) => {
      if (wall !== "wall" || !cart2) return 0;
      const reach2 = cart2.length / 2 - cart2.bumper_length;
      return Array.from(x[cart2.name] ?? []).reduce(
        (most, centre) => Math.max(most, way * (centre - at) + reach2),
        0
      );
    });
    return Math.max(...gives);
  }
  function lengthText(metres) {
    return metres < 0.1 ? `${fixed(metres * 1e3, 1)} mm` : `${fixed(metres * 100, 1)} cm`;
  }

  // src/scene/beside/views.js
  var KINDS = {
    "free-body": [tr("forces on each cart"), FreeBody],
    lens: [tr("lens on the contact"), Lens],
    bars: [tr("momentum before and now"), Bars]
  };
  var Views = class {
    #views = [];
    #now = null;
    constructor(root, baked) {
      this.frames = root.querySelectorAll(".carts-views");
      for (const section of root.querySelectorAll(".carts-view")) {
        const element = section;
        const kind2 = KINDS[element.dataset.view ?? ""];
        if (kind2) this.#views.push(new kind2[1](element, baked, () => this.#again()));
      }
    }
    get choices() {
      return this.#views.map(({ root }) => {
        const key2 = root.dataset.view ?? "";
        return { key: key2, label: KINDS[key2]?.[0] ?? key2, seen: !root.hidden };
      });
    }
    choose(key2, seen) {
      for (const { root } of this.#views) if (root.dataset.view === key2) root.hidden = !seen;
      this.#again();
    }
    show(run, windows, t) {
      if (!isTold(run)) return;
      for (const frame3 of this.frames) frame3.hidden = false;
      this.#now = { run, windows, t };
      for (const view of this.#views) view.show(run, windows);
    }
    at(t) {
      if (!this.#now) return;
      this.#now.t = t;
      for (const view of this.#views) if (!view.root.hidden) view.at(t);
    }
    #again() {
      if (this.#now) this.at(this.#now.t);
    }
  };

  // src/shared/follow.js
  function followPointer(down, moved) {
    if (down.button > 0) return false;
    const leaving = new AbortController();
    const { signal } = leaving;
    const follow = (now) => {
      if (now.pointerId !== down.pointerId) return;
      if (now.buttons & 1) moved(now.clientX - down.clientX, now);
      else leaving.abort();
    };
    addEventListener("pointermove", follow, { signal });
    addEventListener("pointerup", follow, { signal });
    addEventListener("pointercancel", follow, { signal });
    return true;
  }
  var FAR2 = 8;
  function onPointed(place2, point) {
    place2.addEventListener("click", point);
    place2.addEventListener("pointerdown", (down) => {
      let points = down.pointerType === "mouse";
      const moved = (pixels2, now) => {
        points ||= Math.abs(pixels2) > Math.max(FAR2, Math.abs(now.clientY - down.clientY));
        if (points) point(now);
      };
      if (followPointer(down, moved)) moved(0, down);
    });
  }

  // src/scene/how/ghost.js
  function ghostCurves(plot2, curves, times2, plane) {
    const found = plot2.querySelector('[data-part="ghost"]');
    if (!curves.length) return found?.remove();
    const front = plot2.querySelector('[data-part="curves"]');
    const clip = front?.getAttribute("clip-path") ?? "none";
    const group = found ?? svg("g", { "data-part": "ghost", "clip-path": clip });
    if (!found) front?.before(group);
    group.replaceChildren(
      ...curves.filter(({ over: over2 }) => !over2).map((curve3) => svg("path", { class: "carts-pale", d: path(curve3, times2, plane) }))
    );
  }

  // src/scene/graphs/axes.js
  function drawAxes(root, plane) {
    const times2 = timeMarks(plane);
    const rows = valueMarks(plane);
    marks2(need(root, '[data-part="times"]'), times2.length, (line2, text3, i) => {
      const { at, textX, label } = times2[i];
      put(line2, "class", "carts-grid");
      put(line2, "d", `M${at} ${TOP4}V${BOTTOM4}`);
      put(text3, "class", "carts-tick-x");
      put(text3, "x", textX);
      put(text3, "y", String(BOTTOM4 + 15));
      say(text3, label);
    });
    marks2(need(root, '[data-part="values"]'), rows.length, (line2, text3, i) => {
      const { at, textY, label, zero } = rows[i];
      put(line2, "class", zero ? "carts-zero" : "carts-grid");
      put(line2, "d", `M${LEFT4} ${at}H${RIGHT4}`);
      put(text3, "class", "carts-tick-y");
      put(text3, "x", String(LEFT4 - GAP));
      put(text3, "y", textY);
      say(text3, label);
    });
    power2(need(root, ".carts-plot"), valuePower(plane));
  }
  function power2(plot2, exponent2) {
    const found = plot2.querySelector('[data-part="power"]');
    if (!exponent2) return found?.remove();
    const at = { class: "carts-unit", "data-part": "power", x: LEFT4 + 4, y: TOP4 + 10 };
    const text3 = found ?? plot2.appendChild(svg("text", at));
    say(text3, `× 10${superscript(exponent2)}`);
  }
  function marks2(group, count, draw) {
    while (group.children.length > 2 * count) group.lastElementChild?.remove();
    while (group.children.length < 2 * count) group.append(svg("path"), svg("text"));
    for (let i = 0; i < count; i += 1) {
      draw(
        group.children[2 * i],
        group.children[2 * i + 1],
        i
      );
    }
  }

  // ../view/impulse.js
  function area2({ trajectory }, pair, from, to) {
    const { t, F, dF } = trajectory;
    const [values, slopes] = [F[pair] ?? [], dF[pair] ?? []];
    let sum = 0;
    for (let k = Math.max(0, rowAt(t, from)); k < t.length - 1 && Number(t[k]) < to; k += 1) {
      const [low, high] = [Math.max(from, Number(t[k])), Math.min(to, Number(t[k + 1]))];
      if (high <= low) continue;
      const at = (when) => hermite(t, values, slopes, k, when);
      sum += (high - low) / 6 * (at(low) + 4 * at((low + high) / 2) + at(high));
    }
    return sum;
  }
  function changes({ header, trajectory }, windows, touch, t) {
    const felt = (pair) => header.events.some(
      (event) => event.bodies?.join("-") === pair && event.t <= t && (event.t >= touch.start || trajectory.F[pair])
    );
    return touch.bodies.map((name) => {
      const mass = header.bodies.find((body2) => body2.name === name)?.mass;
      const others = windows.some(
        (one) => one !== touch && one.bodies.includes(name) && one.start < t && one.end > touch.start
      );
      const acting = header.effects.some(
        (effect) => effect.active && effect.carts.includes(name) && !(isLink(effect) && effect.between?.join("-") === touch.pair)
        // what a pair's own spring does is in its F
      );
      const brief2 = header.contacts.some(
        ({ pair, bodies, stiffness }) => pair !== touch.pair && !stiffness && bodies.includes(name) && felt(pair)
      );
      if (mass === void 0 || others || acting || brief2) return { name, change: null };
      const v = (at) => valueAt2(trajectory.t, trajectory.v[name] ?? [], trajectory.a[name] ?? [], at);
      return { name, change: mass * (v(t) - v(touch.start)) };
    });
  }

  // src/scene/graphs/impulse-layer.js
  var ImpulseLayer = class {
    constructor(root, view) {
      this.shade = need(root, '[data-part="areas"]');
      this.note = need(root, ".carts-area-note");
      this.decimals = Math.max(3, view.decimals.p ?? 3);
      this.windows = [];
    }
    show({ header }) {
      this.windows = touches(header.events, header.until).map(
        (touch) => touch.lasts ? { ...touch, end: header.until } : touch
      );
    }
    at(run, plane, t, signed) {
      const touch = latestTouch(this.windows, t);
      const paths = this.shade.children;
      for (const path3 of paths) put(path3, "d", "");
      if (!touch) {
        const hint = tr("Move into a touch: the shaded area is the impulse.");
        return say(this.note, this.windows.length ? hint : "");
      }
      const end2 = Math.min(t, touch.end);
      const outline = (sign) => under2(run, touch, plane, end2, sign);
      put(paths[0], "d", outline(1));
      if (signed) put(paths[1], "d", outline(-1));
      const impulse = area2(run, touch.pair, touch.start, end2);
      const names = dashed(touch.bodies, run.header.track);
      const amount2 = fixed(impulse, this.decimals);
      const parts2 = changes(run, this.windows, touch, end2).filter(({ change }) => change !== null).map(
        ({ name, change }) => tr("m Δv of {name}: {change}", { name, change: fixed(change ?? 0, this.decimals) })
      );
      const shaded = t >= touch.end ? tr("{names}, shaded area: {amount}", { names, amount: amount2 }) : tr("{names}, shaded area so far: {amount}", { names, amount: amount2 });
      const values = [shaded, ...parts2].join("; ");
      const told3 = parts2.length ? tr("{values}, all in N s.", { values }) : `${values} N s`;
      say(this.note, told3);
    }
  };
  function under2({ trajectory: { t, F, dF } }, touch, plane, end2, sign) {
    const force = F[touch.pair];
    const first = rowAt(t, touch.start);
    if (!force || first < 0) return "";
    const length = Math.min(rowAt(t, end2) + 2, t.length) - first;
    const part = (column, factor) => Float64Array.from({ length }, (_, k) => factor * Number(column[first + k]));
    const [values, slope] = [part(force, sign), dF[touch.pair]];
    const slopes = slope ? part(slope, sign) : null;
    const curve3 = { label: "", style: "", over: false, values, slopes };
    const drawn = path(curve3, part(t, 1), plane, end2);
    const zero = px(valueY(plane, 0));
    return `M${px(timeX(plane, Number(t[first])))} ${zero}L${drawn.slice(1)}V${zero}Z`;
  }

  // src/scene/graphs/key.js
  var Key = class {
    #told = "";
    constructor(root) {
      this.root = root;
    }
    show(curves, note) {
      const wanted = [...curves.map((c) => `${c.style}${c.over}${c.label}`), note].join("|");
      if (this.#told === wanted && this.root.firstChild) return;
      this.#told = wanted;
      this.root.replaceChildren(...curves.map(entry), ...note ? [html2("span", "", note)] : []);
    }
    forget() {
      this.#told = "";
    }
  };
  function entry({ style, over: over2, label }) {
    const made = html2("span", `carts-${style}`);
    const size = { viewBox: "0 0 26 10", width: 26, height: 10, "aria-hidden": "true" };
    const sample2 = svg("svg", size);
    const line2 = { class: `carts-curve carts-${style}${over2 ? " carts-over" : ""}`, d: "M0 5H26" };
    const marker = { class: `carts-dot carts-${style}`, d: MARKERS[style] ?? "" };
    sample2.append(svg("path", line2), svg("path", { ...marker, transform: "translate(13 5)" }));
    made.append(sample2, label);
    return made;
  }

  // ../view/ledger.js
  var HELD = 1e-3;
  function ledger({ header, trajectory }, windows, camera) {
    const moving = seriesOf("energy", header, trajectory, camera).filter((c) => c.style !== "total");
    const times2 = trajectory.t;
    const sum = (k) => moving.reduce((s, c) => s + Number(c.values[k]), 0);
    const start = sum(0);
    const squeezed = new Float64Array(times2.length);
    const warmed2 = new Float64Array(times2.length);
    const last = Math.max(0, start - sum(times2.length - 1));
    const held = Number(header.energy?.parts.bumpers?.final ?? 0) > HELD * last;
    const groups = together2(
      windows.map((touch) => held && touch.lasts ? { ...touch, end: Infinity } : touch)
    );
    let kept = 0;
    for (let k = 0; k < times2.length; k += 1) {
      const t = Number(times2[k]);
      const away = Math.max(0, start - sum(k));
      const on = groups.some((group) => t >= group.start && t < group.end);
      if (!on) kept = away;
      warmed2[k] = Math.min(kept, away);
      squeezed[k] = away - Number(warmed2[k]);
    }
    return [
      ...moving.map((curve3) => ({ ...curve3, label: tr("motion of {cart}", { cart: curve3.label }) })),
      {
        label: tr("in squeezed bumpers"),
        style: "squeezed",
        over: false,
        values: squeezed,
        slopes: null
      },
      {
        label: tr("has warmed the {things}", { things: tr("bumpers") }),
        style: "warmed",
        over: false,
        values: warmed2,
        slopes: null
      }
    ];
  }
  function together2(windows) {
    const groups = [];
    for (const { start, end: end2 } of windows) {
      const last = groups.at(-1);
      if (last && start < last.end) last.end = Math.max(last.end, end2);
      else groups.push({ start, end: end2 });
    }
    return groups;
  }
  function stacked(entries2) {
    let below = new Float64Array(entries2[0]?.values.length ?? 0);
    return entries2.map((entry2) => {
      below = Float64Array.from(below, (value, k) => value + Number(entry2.values[k]));
      return { ...entry2, values: below };
    });
  }

  // ../view/ledger-effects.js
  var WANTED = "carts-energy-wanted";
  var [BUMPERS, WARMED] = ["bumpers", "warmed"];
  var AROUND = tr("surroundings");
  function needsParts({ fence }) {
    return (fence.scene.effects ?? []).length > 0;
  }
  function askParts(root) {
    return new Promise((resolve) => {
      const detail = { answer: resolve, heard: false };
      root.dispatchEvent(new CustomEvent(WANTED, { bubbles: true, detail }));
      if (!detail.heard) resolve(null);
    });
  }
  function ledgerWithEffects(header, parts2) {
    const column = (name) => parts2.columns[parts2.names.indexOf(name)] ?? new Float64Array(parts2.t.length);
    const bands = parts2.moving.map((values, i) => ({
      label: tr("motion of {cart}", { cart: header.bodies[i]?.name ?? "" }),
      style: styleOf(i),
      over: false,
      values,
      slopes: null
    }));
    for (const name of parts2.names.filter((one) => one !== WARMED)) {
      const [label, style] = name === BUMPERS ? [tr("in squeezed bumpers"), "squeezed"] : [stored(name, header), "stored"];
      if (!label) continue;
      const values = column(name);
      const lowest = values.reduce((least, value) => Math.min(least, value), 0);
      const above = Float64Array.from(values, (value) => value - lowest);
      bands.push({ label, style, over: false, values: above, slopes: null });
    }
    const warm = { values: column(WARMED), style: "warmed", over: false, slopes: null };
    bands.push({ ...warm, label: warmed(header) });
    return bands;
  }
  function stored(kind2, { effects }) {
    const { lasts, stored: where = "" } = viewOf(kind2);
    return !lasts || effects.some((one) => one.kind === kind2 && lasts(one)) ? where : "";
  }
  function warmed({ contacts, effects }) {
    const what = contacts.length ? [tr("bumpers")] : [];
    for (const effect of effects.filter(({ active }) => active)) {
      what.push(viewOf(effect.kind).warms?.(effect) ?? "");
    }
    const names = [...new Set(what.filter(Boolean))];
    const things = listed(names) || AROUND;
    return tr("has warmed the {things}", { things });
  }

  // src/scene/graphs/ledger-layer.js
  var NEAR2 = 0.5;
  function hasLedger(baked) {
    const { left, right } = baked.run.header.track;
    return !baked.fence.camera || left !== "wall" && right !== "wall" && !needsParts(baked);
  }
  var LedgerLayer = class {
    times = [];
    #of = null;
    entries = [];
    tops = [];
    waits = "";
    // why it is not there yet, or not at all
    constructor(root, baked) {
      this.areas = need(root, '[data-part="areas"]');
      this.key = need(root, ".carts-key");
      this.root = root;
      this.asks = needsParts(baked);
      this.camera = baked.fence.camera;
      this.decimals = baked.view.decimals.energy ?? 3;
    }
    show(run, open2, changed) {
      const { events, until } = run.header;
      if (!this.asks) {
        this.#take(run.trajectory.t, ledger(run, touches(events, until), this.camera));
      } else if (open2 && this.#of !== run) {
        this.#of = run;
        this.waits = tr("Computing …");
        void askParts(this.root).then((parts2) => {
          if (this.#of !== run) return;
          this.waits = parts2 ? "" : tr("This change needs Python, which does not run here.");
          this.#take(parts2?.t ?? [], parts2 ? ledgerWithEffects(run.header, parts2) : []);
          changed();
        });
      }
    }
    #take(times2, entries2) {
      this.times = times2;
      this.entries = entries2;
      this.tops = stacked(entries2);
    }
    clear() {
      this.areas.replaceChildren();
    }
    draw(plane) {
      while (this.areas.children.length < this.tops.length) this.areas.append(svg("path"));
      while (this.areas.children.length > this.tops.length) this.areas.lastElementChild?.remove();
      this.tops.forEach((top, i) => {
        const path3 = this.areas.children[i];
        put(path3, "class", `carts-band carts-${top.style}`);
        put(path3, "d", band3(this.times, plane, top.values, this.tops[i - 1]?.values));
      });
      this.key.replaceChildren(
        ...this.entries.map(({ style }) => {
          const entry2 = document.createElement("span");
          const swatch = svg("svg", { viewBox: "0 0 14 12", width: 14, height: 12 });
          swatch.setAttribute("aria-hidden", "true");
          swatch.append(svg("path", { class: `carts-band carts-${style}`, d: "M1 1H13V11H1Z" }));
          entry2.className = `carts-${style}`;
          entry2.append(swatch, document.createElement("b"));
          return entry2;
        })
      );
    }
    at(t) {
      this.entries.forEach(({ label, values }, i) => {
        const now = Math.max(0, valueAt2(this.times, values, null, t));
        const text3 = this.key.children[i]?.querySelector("b");
        if (text3) say(text3, `${label}: ${fixed(now, this.decimals)} J`);
      });
    }
  };
  function band3(times2, plane, top, bottom) {
    const above = [];
    const below = [];
    let [x0, y0, z0] = [-9, -9, -9];
    for (let k = 0; k < times2.length; k += 1) {
      const x = timeX(plane, Number(times2[k]));
      const [y, z] = [Number(top[k]), Number(bottom?.[k] ?? 0)].map((v) => valueY(plane, v));
      const moved = Math.max(Math.abs(x - x0), Math.abs(Number(y) - y0), Math.abs(Number(z) - z0));
      if (moved < NEAR2 && k < times2.length - 1) continue;
      [x0, y0, z0] = [x, Number(y), Number(z)];
      above.push(`${px(x)} ${px(y0)}`);
      below.unshift(`${px(x)} ${px(z0)}`);
    }
    return `M${above.join("L")}L${below.join("L")}Z`;
  }

  // src/scene/graphs/table.js
  var ROWS2 = 10;
  var MOST_EVENTS = 24;
  var WITHIN = 9;
  var MOST_CONTACTS = 3;
  var OF_CONTACTS = ["F", "R", "a"];
  var REST = 250;
  var Table = class {
    #waiting = null;
    #timer = 0;
    #seen = Infinity;
    // s, as far as the run was watched
    #shown = null;
    #rows = 0;
    constructor(details, quantity, view) {
      this.details = details;
      this.quantity = quantity;
      this.view = view;
      details.addEventListener("toggle", () => {
        this.#waiting = this.#shown;
        this.fill();
      });
    }
    show(run, curves, rows) {
      this.#waiting = { run, curves, rows };
      this.#shown = this.#waiting;
      clearTimeout(this.#timer);
      this.#timer = setTimeout(() => this.fill(), this.details.open ? 0 : REST);
    }
    grow(seen) {
      this.#seen = seen;
      if (!this.#shown || this.#times(this.#shown.run).length === this.#rows) return;
      this.#waiting = this.#shown;
      if (this.details.open || seen === Infinity) this.fill();
    }
    fill() {
      if (!this.#waiting) return;
      const { run, curves, rows: instants } = this.#waiting;
      this.#waiting = null;
      const speed = speedUnit(this.view.velocity)[1];
      const unit = this.quantity === "v" ? speed : QUANTITIES[this.quantity]?.[2] ?? "";
      const head = html2("tr");
      head.append(
        heading(tr("t in s")),
        ...curves.map((curve3) => heading(`${curve3.label}, ${unit}`))
      );
      need(this.details, "thead").replaceChildren(head);
      const decimals = this.view.decimals[this.quantity] ?? 3;
      const scale = greatest2(curves);
      const times2 = this.#times(run);
      this.#rows = times2.length;
      const rows = times2.map((t) => {
        const row2 = html2("tr");
        row2.append(html2("td", "", fixed(t, this.view.decimals.t ?? 3)));
        for (const { values, slopes } of curves) {
          const value = valueAt2(instants, values, slopes, t);
          row2.append(html2("td", "", fixed(Math.abs(value) < NOISE * scale ? 0 : value, decimals)));
        }
        return row2;
      });
      need(this.details, "tbody").replaceChildren(...rows);
    }
    #times(run) {
      const told3 = this.details.open && OF_CONTACTS.includes(this.quantity);
      const within = told3 ? contactTimes(run) : [];
      const times2 = /* @__PURE__ */ new Set([...tableTimes(run), ...within]);
      return [...times2].filter((t) => t <= this.#seen).sort((a, b) => a - b);
    }
  };
  function contactTimes(run) {
    const { trajectory } = run;
    const last = Number(trajectory.t[trajectory.t.length - 1]);
    return windowsOf(run).slice(0, MOST_CONTACTS).flatMap(
      ({ start, end: end2 }) => Array.from({ length: WITHIN }, (_, k) => start + (k + 1) / (WITHIN + 1) * (end2 - start))
    ).filter((t) => t <= last);
  }
  function tableTimes({ header, trajectory }) {
    const times2 = /* @__PURE__ */ new Set([...ticks2(span(0, header.until, ROWS2)), header.until]);
    for (const event of header.events.slice(0, MOST_EVENTS)) times2.add(event.t);
    const last = Number(trajectory.t[trajectory.t.length - 1]);
    return [...times2].filter((t) => t <= last).sort((a, b) => a - b);
  }
  function heading(text3) {
    const cell2 = html2("th", "", text3);
    cell2.setAttribute("scope", "col");
    return cell2;
  }
  function greatest2(curves) {
    let found = 0;
    for (const { values } of curves) {
      for (let k = 0; k < values.length; k += 1) found = Math.max(found, Math.abs(Number(values[k])));
    }
    return found || 1;
  }

  // src/scene/graphs/graph-view.js
  var GraphView = class {
    #curves = [];
    #run = null;
    #first = null;
    #plane = planeFor([0, 1], [0, 1]);
    #dots = [];
    behind = null;
    drawn = () => {
    };
    #pressed = false;
    // “with sign”, “as a ledger”
    #t = 0;
    // s, the instant shown
    #seen = Infinity;
    // s, as far as the run was watched
    #window = null;
    constructor(root, baked, seek) {
      this.root = root;
      this.quantity = root.dataset.quantity ?? "x";
      this.camera = baked.fence.camera;
      this.signedName = forceName(baked.run.header);
      this.name = sizeName(baked.run.header);
      this.reach = baked.view.reach[this.quantity] ?? [0, 0, 1, 0];
      this.per = speedUnit(baked.view.velocity)[0];
      this.plot = need(root, ".carts-plot");
      this.key = new Key(need(root, ".carts-key"));
      this.table = new Table(need(root, "details"), this.quantity, baked.view);
      this.button = root.querySelector(".carts-sign");
      this.impulse = this.quantity === "F" ? new ImpulseLayer(root, baked.view) : null;
      this.ledger = this.quantity === "energy" && hasLedger(baked) ? new LedgerLayer(root, baked) : null;
      if (this.quantity === "energy" && !this.ledger && this.button) this.button.hidden = true;
      this.button?.addEventListener("click", () => this.#toggle());
      onPointed(this.plot, (event) => {
        const frame3 = this.plot.getBoundingClientRect();
        const x = (event.clientX - frame3.left) / frame3.width * WIDTH4;
        const part = Math.min(1, Math.max(0, (x - LEFT4) / (RIGHT4 - LEFT4)));
        const { low, high } = this.#plane.time;
        seek(low + part * (high - low));
      });
    }
    enable() {
      if (this.button) this.button.disabled = false;
    }
    show(run, t) {
      if (!isTold(run)) return;
      this.#run = run;
      if (run.trajectory.t.length > 1) this.#first ??= run;
      this.impulse?.show(run);
      this.ledger?.show(run, this.#pressed, () => this.show(run, this.#t));
      this.#draw(t);
      const told3 = this.#stacked ? this.ledger?.entries ?? [] : this.#curves;
      this.table.show(run, told3, this.#times(run));
    }
    grow(seen) {
      this.#seen = seen;
      this.table.grow(seen);
      if (this.#run) seen === Infinity ? this.#draw(this.#t) : this.#lines(this.#run);
    }
    zoom(window2, t) {
      this.#window = window2;
      if (this.#run) this.#draw(t);
    }
    at(t) {
      this.#t = t;
      const run = this.#run;
      if (!run) return;
      const x = px(timeX(this.#plane, t));
      this.impulse?.at(run, this.#plane, t, this.#pressed);
      if (this.#stacked) this.ledger?.at(t);
      put(need(this.root, ".carts-cursor"), "transform", `translate(${x} 0)`);
      this.#curves.forEach((curve3, i) => {
        const y = valueY(this.#plane, valueAt2(this.#times(run), curve3.values, curve3.slopes, t));
        const dot2 = this.#dots[i];
        if (dot2) put(dot2, "transform", `translate(${x} ${px(y)})`);
      });
    }
    get #signed() {
      return this.#pressed && this.quantity === "F";
    }
    get #stacked() {
      return this.#pressed && this.ledger !== null && this.ledger.entries.length > 0;
    }
    #times(run) {
      return this.#stacked ? this.ledger?.times ?? [] : run.trajectory.t;
    }
    #toggle() {
      this.#pressed = !this.#pressed;
      this.button?.setAttribute("aria-pressed", String(this.#pressed));
      this.#name();
      this.root.dispatchEvent(new CustomEvent("carts-redraw", { bubbles: true }));
    }
    #name() {
      const [title, symbol, rest] = this.ledger ? [this.#stacked ? tr("Energy") : tr("Kinetic energy"), "E", tr(" in {unit}", { unit: "J" })] : this.#pressed ? [this.signedName, "F", tr(" in N, + is right")] : [this.name, "|F|", tr(" in {unit}", { unit: "N" })];
      const italic = Object.assign(document.createElement("i"), { textContent: symbol });
      need(this.root, ".carts-graph-name").replaceChildren(`${title} `, italic, rest);
    }
    #draw(t) {
      const run = this.#run;
      const { header } = run;
      this.#curves = this.#curvesOf(run);
      const behind = this.behind && !this.#stacked ? this.#curvesOf(this.behind) : [];
      const first = this.#first ? extent(this.#curvesOf(this.#first), this.#times(this.#first)) : [0, 0];
      const all = [
        extent(this.#curves, this.#times(run)),
        extent(behind, this.behind?.trajectory.t ?? []),
        reached(first, this.reach, this.#signed)
      ];
      const low = Math.min(...all.map((one) => one[0]));
      const high = Math.max(...all.map((one) => one[1]));
      this.#plane = planeFor([low, high], this.#window ?? [0, header.until]);
      drawAxes(this.root, this.#plane);
      const group = need(this.root, '[data-part="curves"]');
      fit(group, this.#curves.length, () => svg("path"));
      this.#curves.forEach((curve3, i) => {
        const line2 = group.children[i];
        put(line2, "class", `carts-curve carts-${curve3.style}${curve3.over ? " carts-over" : ""}`);
      });
      this.#lines(run);
      ghostCurves(this.plot, behind, this.behind?.trajectory.t ?? [], this.#plane);
      this.drawn(this, this.#plane);
      this.#cursor();
      if (this.#stacked) {
        this.ledger?.draw(this.#plane);
        this.key.forget();
      } else {
        this.ledger?.clear();
        const whole = this.#seen === Infinity;
        const note = whole ? graphNote(this.quantity, header.events, this.#curves.length) : "";
        this.key.show(this.#curves, this.#pressed && this.ledger?.waits || note);
      }
      if (this.ledger) this.#name();
      this.at(t);
    }
    #lines(run) {
      const group = need(this.root, '[data-part="curves"]');
      this.#curves.forEach((curve3, i) => {
        const line2 = group.children[i];
        put(line2, "d", path(curve3, this.#times(run), this.#plane, this.#seen));
      });
      const room = this.root.querySelector(".carts-seen rect");
      const end2 = Math.min(RIGHT4, Math.max(LEFT4, timeX(this.#plane, this.#seen)));
      if (room) put(room, "width", px(end2 - LEFT4 + 1));
    }
    #curvesOf({ header, trajectory }) {
      if (this.#stacked) return this.ledger?.tops ?? [];
      return seriesOf(this.quantity, header, trajectory, this.camera, this.#signed, this.per);
    }
    #cursor() {
      const group = need(this.root, '[data-part="cursor"]');
      fit(group, this.#curves.length + 1, () => svg("path"));
      this.#dots = [...group.children].slice(1);
      this.#dots.forEach((dot2, i) => {
        const style = this.#curves[i]?.style ?? "b0";
        put(dot2, "class", `carts-dot carts-${style}`);
        put(dot2, "d", MARKERS[style] ?? "");
      });
    }
  };

  // src/scene/readouts.js
  var Readouts = class {
    #run = null;
    constructor(root, baked) {
      this.camera = baked.fence.camera;
      this.decimals = baked.view.decimals;
      this.per = speedUnit(baked.view.velocity)[0];
      this.zero = NOISE * (baked.view.force || 1);
      this.cards = baked.run.header.bodies.map(({ name }) => {
        const card = need(root, `.carts-card[data-body="${name}"]`);
        const outputs = card.querySelectorAll(".carts-value");
        return { name, outputs: new Map([...outputs].map((o) => [o.dataset.quantity ?? "", o])) };
      });
    }
    show(run) {
      this.#run = run;
    }
    at(t) {
      const run = this.#run;
      if (!run) return;
      const { t: times2, x, v, a } = run.trajectory;
      const told3 = isTold(run);
      for (const { name, outputs } of this.cards) {
        const mass = run.header.bodies.find((body2) => body2.name === name)?.mass ?? 0;
        const force = told3 ? resultant(run, name, t, this.zero) : null;
        const values = /* @__PURE__ */ new Map([
          ["x", valueAt2(times2, x[name] ?? [], v[name] ?? [], t) - this.camera * t],
          ["v", (valueAt2(times2, v[name] ?? [], a[name] ?? [], t) - this.camera) / this.per],
          ["F", force],
          ["a", force === null ? null : force / mass]
        ]);
        for (const [quantity, output] of outputs) {
          if (quantity === "mass") {
            say(output, short(mass));
            continue;
          }
          const value = values.get(quantity) ?? null;
          const decimals = this.decimals[quantity] ?? 3;
          say(output, value === null ? "–" : fixed(value, decimals));
        }
      }
    }
  };

  // ../view/deformation/squeezes.js
  function squeezes(carts, centres, faces) {
    const left = carts.map(() => 0);
    const right = carts.map(() => 0);
    const dents = { left: 0, right: 0 };
    for (let gap = 0; gap <= carts.length; gap += 1) {
      const [a, b] = [carts[gap - 1], carts[gap]];
      const end2 = a ? Number(centres[gap - 1]) + a.half : faces.left;
      const start = b ? Number(centres[gap]) - b.half : faces.right;
      if (end2 === null || start === null) continue;
      const overlap = Math.max(0, end2 - start);
      const share = Math.min(a?.bumper ?? 0, b ? overlap / 2 : overlap);
      const rest = Math.min(b?.bumper ?? 0, overlap - share);
      if (b) left[gap] = rest;
      if (a) right[gap - 1] = Math.min(a.bumper, overlap - rest);
      if (!a) dents.left = overlap - rest;
      if (!b) dents.right = overlap - share;
    }
    return { left, right, dents };
  }

  // src/predict/pull.js
  function pullable(stage2, slider2, full, width) {
    const group = svg("g", {});
    group.addEventListener("pointerdown", (event) => {
      const down = event;
      if (slider2.disabled) return;
      event.preventDefault();
      const start = slider2.valueAsNumber || 0;
      const perPixel = width / stage2.getBoundingClientRect().width * Number(slider2.max) / full;
      followPointer(down, (pixels2) => {
        if (slider2.disabled) return;
        const before2 = slider2.value;
        slider2.valueAsNumber = start + pixels2 * perPixel;
        if (slider2.value !== before2 || slider2.dataset.pulled === void 0) {
          slider2.dataset.pulled = "";
          slider2.dispatchEvent(new Event("input", { bubbles: true }));
        }
      });
    });
    return group;
  }

  // ../view/effects-props.js
  function isSeen(effect, t) {
    const { seen } = viewOf(effect.kind);
    return seen ? effect.active && seen(effect, t) : actsAt(effect, t);
  }
  function props(run, layout, t, face2, centre) {
    const { header } = run;
    return header.effects.filter((effect) => isSeen(effect, t)).flatMap((effect) => {
      const key2 = `${effect.kind} ${effect.index}`;
      return viewOf(effect.kind).pieces?.(effect, { key: key2, header, run, t, layout, face: face2, centre }) ?? [];
    });
  }

  // src/scene/effects.js
  var PER_CHARACTER = 8.4;
  var SLIVER = 1.5;
  var GAP3 = 8;
  var Effects = class {
    #run = null;
    #drawn = /* @__PURE__ */ new Map();
    constructor(root, layout, full, forces2) {
      this.layout = layout;
      this.full = full;
      this.forces = forces2;
      this.behind = need(root, '[data-part="effects-behind"]');
      this.front = need(root, '[data-part="effects-front"]');
      for (const group of [this.behind, this.front]) {
        for (const element of group.querySelectorAll("[data-key]")) {
          this.#drawn.set(
            element.getAttribute("data-key") ?? "",
            element
          );
        }
      }
    }
    show(run) {
      this.#run = run;
    }
    at(t, face2, centre) {
      const run = this.#run;
      if (!run?.header.effects.length) return;
      const pieces = props(run, this.layout, t, face2, centre);
      if (this.forces && isTold(run)) pieces.push(...arrows2(run, this.layout, this.full, t, centre));
      const seen = new Set(pieces.map(({ key: key2 }) => key2));
      for (const [key2, element] of this.#drawn) {
        if (!seen.has(key2)) {
          element.remove();
          this.#drawn.delete(key2);
        }
      }
      for (const piece of pieces) this.#draw(piece);
    }
    #draw({ key: key2, cls, behind, d, text: text3, x, y, anchor }) {
      let element = this.#drawn.get(key2);
      if (!element) {
        element = svg(d === void 0 ? "text" : "path", { "data-key": key2, class: cls });
        const group = behind ? this.behind : this.front;
        if (cls.startsWith("carts-leader")) group.prepend(element);
        else group.append(element);
        this.#drawn.set(key2, element);
      }
      if (d !== void 0) return put(element, "d", d);
      put(element, "x", x ?? "0");
      put(element, "y", y ?? "0");
      put(element, "text-anchor", anchor ?? "start");
      say(element, text3 ?? "");
    }
  };
  function arrows2(run, layout, full, t, centre) {
    const styles = new Map(run.header.bodies.map(({ name }, i) => [name, `carts-${styleOf(i)}`]));
    const named2 = run.header.bodies.length <= FEW2;
    const pieces = [];
    const lowest = /* @__PURE__ */ new Map();
    for (const force of forcesAt(run, t)) {
      const key2 = `${force.kind} ${force.on}`;
      const x = centre(force.on);
      const y = layout.slots[key2] ?? layout.track;
      const exact = arrowLength(force.value, full, layout.force);
      const length = Math.abs(exact) < SLIVER ? 0 : exact;
      const cut = isCut(force.value, full);
      const style = styles.get(force.on);
      lowest.set(force.on, Math.max(y, lowest.get(force.on) ?? y));
      const d = (cut ? cutArrow : blockArrow)(x, y, length);
      pieces.push({ key: `arrow ${key2}`, cls: `carts-block-arrow carts-acts ${style}`, d });
      const row2 = `row ${force.kind}`;
      if (named2) {
        const told3 = labels(force).map((one) => one + (cut ? tr(", arrow cut") : ""));
        const text3 = told3.find((one) => fits(x, length, one, layout.width)) ?? String(told3.at(-1));
        const [at, anchor] = beside(x, length, text3.length * PER_CHARACTER, layout.width);
        const cls = `carts-acts-name ${style}`;
        pieces.push({ key: `name ${key2}`, cls, text: text3, x: px(at), y: px(y + 5), anchor });
      } else if (!pieces.some((piece) => piece.key === row2)) {
        const text3 = tr("by {by}", { by: force.by });
        pieces.push({ key: row2, cls: "carts-acts-row", text: text3, x: "6", y: px(y + 5), anchor: "start" });
      }
    }
    const leaders = [...lowest].map(([name, y]) => ({
      key: `leader ${name}`,
      cls: `carts-leader carts-acts ${styles.get(name)}`,
      d: `M${px(centre(name))} ${px(layout.track)}V${px(y)}`
    }));
    return [...leaders, ...pieces];
  }
  function fits(x, length, text3, picture2) {
    const needed = text3.length * PER_CHARACTER + GAP3 + 4;
    return Math.min(x, x + length) >= needed || Math.max(x, x + length) <= picture2 - needed;
  }
  function beside(x, length, width, picture2) {
    const left = Math.min(x, x + length) - GAP3;
    const right = Math.max(x, x + length) + GAP3;
    const toLeft = left - width >= 4;
    const toRight = right + width <= picture2 - 4;
    if (toLeft && (length >= 0 || !toRight)) return [left, "end"];
    if (toRight) return [right, "start"];
    return left > picture2 - right ? [4, "start"] : [picture2 - 4, "end"];
  }

  // src/scene/ground.js
  var TRACK2 = "track.length";
  var Ground = class {
    #lines = [];
    #numbers = [];
    constructor(root, layout, { fence, run: { header } }) {
      this.layout = layout;
      this.moves = header.track.right === "wall" && fence.controls.some((control2) => control2.set === TRACK2);
      if (!this.moves) return;
      const ground2 = need(root, '[data-part="ground"]');
      this.beam = need(ground2, ".carts-beam");
      this.rule = need(ground2, ".carts-rule");
      this.#numbers = [...ground2.querySelectorAll(".carts-number")];
      this.#lines = Array.from(ground2.querySelectorAll(".carts-fine"), (drawn) => ({
        drawn,
        pieces: (drawn.getAttribute("d") ?? "").split(/(?=M)/).filter(Boolean).map((d) => ({ x: Number.parseFloat(d.slice(1)), d }))
      }));
    }
    show({ length }) {
      if (!this.beam || !this.rule) return;
      const end2 = this.layout.origin + Number(length) * this.layout.scale;
      const inside7 = (x) => x <= end2 + 1;
      const start = Number(this.beam.getAttribute("x"));
      put(this.beam, "width", px(end2 - start));
      put(this.rule, "d", `M${px(start)} ${px(this.layout.track)}H${px(end2)}`);
      for (const { drawn, pieces } of this.#lines) {
        const d = pieces.filter(({ x }) => inside7(x)).map((piece) => piece.d);
        put(drawn, "d", d.join(""));
      }
      for (const number of this.#numbers) {
        const seen = inside7(Number(number.getAttribute("x")));
        put(number, "visibility", seen ? "visible" : "hidden");
      }
    }
  };

  // src/scene/pushes.js
  var PER_CHARACTER2 = 9.1;
  var ROW2 = 21;
  var GAP4 = 12;
  var EDGE3 = 6;
  var Pushes = class {
    #pushes = [];
    #run = null;
    #windows = [];
    constructor(root, layout, view) {
      this.root = root;
      this.layout = layout;
      this.view = view;
    }
    show(run, windows) {
      this.#run = run;
      this.#windows = windows;
      this.#pushes = [];
      run.header.contacts.forEach((contact, k) => {
        const groups = contact.bodies.map(
          (name) => this.root.querySelector(`.carts-push[data-pair="${contact.pair}"][data-on="${name}"]`)
        );
        if (groups[0] && groups[1]) {
          const row2 = this.layout.rows[k] ?? 0;
          this.#pushes.push({
            pair: contact.pair,
            bodies: contact.bodies,
            row: row2,
            groups: [groups[0], groups[1]]
          });
        }
      });
    }
    at(t, face2) {
      const run = this.#run;
      if (!run) return;
      const { layout, view } = this;
      const told3 = [];
      for (const push2 of this.#pushes) {
        const forces2 = forcesOn(run, push2, t).map(
          (force) => Math.abs(force) < NOISE * view.force ? 0 : force
          // springs pull: below 0
        );
        const sizes = forces2.map(Math.abs);
        const size = Math.max(...sizes);
        const y = layout.track - PUSH;
        const [left, right] = push2.bodies;
        const ends2 = [face2(left, "right"), face2(right, "left")];
        push2.groups.forEach((group, side2) => {
          const way = side2 === 0 ? -1 : 1;
          const draw = isCut(Number(sizes[side2]), view.force) ? cutArrow : blockArrow;
          const length = arrowLength(Number(forces2[side2]), view.force, layout.force);
          put(need(group, '[data-part="arrow"]'), "d", draw(Number(ends2[side2]), y, way * length));
        });
        const touching = this.#windows.some(
          ({ pair, loose, near: near2, start, end: end2, lasts }) => pair === push2.pair && !(loose || near2) && t >= start && (t <= end2 || Boolean(lasts && size > 0))
          // carts that never part go on pushing
        );
        const link = touching ? "" : linkOf(run.header, push2.pair);
        if (touching || link && size > 0) {
          told3.push({ push: push2, sizes, x: (Number(ends2[0]) + Number(ends2[1])) / 2, link });
        }
      }
      this.#names(told3);
    }
    #names(told3) {
      const [only] = told3;
      for (const { pair, groups } of this.#pushes) {
        const on = told3.some(({ push: push2 }) => push2.pair === pair);
        for (const group of groups) {
          put(need(group, '[data-part="text"]'), "visibility", on ? "visible" : "hidden");
        }
      }
      if (told3.length === 1 && only && this.#inFull(only)) return;
      const taken = [];
      const [low, high] = this.#between();
      for (const { push: push2, sizes, x } of told3) {
        const size = Math.max(...sizes);
        const [text3, other] = push2.groups.map((group) => need(group, '[data-part="text"]'));
        if (!text3 || !other) continue;
        const label = tr("{size} on each", { size: this.#value(size) });
        const half = label.length * PER_CHARACTER2 / 2;
        const at = Math.min(Math.max(x, low + half), high - half);
        const free = [...new Set(this.layout.rows)].find(
          (y) => taken.every(([row2, from, to]) => row2 !== y || at + half < from || at - half > to)
        );
        put(other, "visibility", "hidden");
        if (free === void 0) put(text3, "visibility", "hidden");
        else {
          taken.push([free, at - half, at + half]);
          write(text3, label, at, free, "middle");
        }
      }
    }
    #inFull(told3) {
      return this.#named(told3, told3.link && ` (${told3.link})`) || this.#named(told3, "");
    }
    #named({ push: push2, sizes, x }, through) {
      const [first, second] = push2.groups.map((group) => need(group, '[data-part="text"]'));
      const { track } = this.#run.header;
      const labels2 = push2.bodies.map((on, side2) => {
        const by = push2.bodies[1 - side2] ?? "";
        return `${onBy(on, by, track)}${through}: ${this.#value(Number(sizes[side2]))}`;
      });
      const [left, right] = labels2.map((label) => label.length * PER_CHARACTER2);
      if (!first || !second || !left || !right) return false;
      const [low, high] = this.#between();
      if (high - low >= left + right + 2 * GAP4 && !push2.bodies.some(isWall)) {
        const begin = Math.min(Math.max(x + GAP4, low + left + 2 * GAP4), high - right);
        const end2 = Math.max(low + left, Math.min(x - GAP4, begin - 2 * GAP4));
        write(first, labels2[0] ?? "", end2, push2.row, "end");
        write(second, labels2[1] ?? "", begin, push2.row, "start");
        return true;
      }
      const longest = Math.max(left, right);
      const taken = new Set(Object.values(this.layout.slots)).size;
      if (this.layout.beam < (2 + taken) * ROW2 || high - low < longest) return false;
      const top = Math.min(...this.layout.rows);
      const way = push2.bodies[0] === "left" ? 0 : push2.bodies[1] === "right" ? 1 : 0.5;
      const start = Math.min(Math.max(x - way * longest, low), high - longest);
      write(first, labels2[0] ?? "", start, top, "start");
      write(second, labels2[1] ?? "", start, top + ROW2, "start");
      return true;
    }
    #between() {
      const { origin, scale, width } = this.layout;
      const track = this.#run?.header.track;
      const end2 = origin + (track?.length ?? 0) * scale;
      return [
        track?.left === "wall" ? Math.max(EDGE3, origin + GAP4) : EDGE3,
        track?.right === "wall" ? Math.min(width - EDGE3, end2 - GAP4) : width - EDGE3
      ];
    }
    #value(size) {
      const cut = isCut(size, this.view.force) ? tr(", arrow cut") : "";
      return `${fixed(size, this.view.decimals.F ?? 2)} N${cut}`;
    }
  };
  function forcesOn({ trajectory }, { pair, bodies }, t) {
    const { t: times2, F, dF, on } = trajectory;
    const [left, right] = bodies.map((name) => on?.[`${pair} ${name}`]);
    if (left && right) return [valueAt2(times2, left, null, t), valueAt2(times2, right, null, t)];
    const [column, slopes] = [F[pair], dF[pair]];
    const force = column && slopes ? valueAt2(times2, column, slopes, t) : 0;
    return [force, force];
  }
  function write(text3, label, x, y, anchor) {
    put(text3, "x", px(x));
    put(text3, "y", px(y));
    put(text3, "text-anchor", anchor);
    say(text3, label);
  }

  // src/scene/walls.js
  var THING = '[data-part="thing"]';
  var Walls = class {
    #walls = [];
    constructor(root, layout, { run: { header }, view }) {
      this.layout = layout;
      this.tallest = view.tallest;
      this.was = need(root, ".carts-was");
      this.#walls = Array.from(root.querySelectorAll("[data-wall]"), (group) => {
        const side2 = group.getAttribute("data-wall") === "left" ? "left" : "right";
        const wall = wallAt(side2, header.track.length, layout, view.tallest);
        return { side: side2, what: "wall", wall, group };
      });
    }
    show(track) {
      for (const one of this.#walls) {
        one.what = whatIs(one.side, track);
        one.wall = wallAt(one.side, track.length, this.layout, this.tallest);
        const drawn = one.group.querySelector(THING);
        if (one.what === "wall") drawn?.remove();
        else if (!drawn) one.group.append(svg("path", { "data-part": "thing" }));
      }
    }
    faces(shift) {
      const at = (side2) => {
        const found = this.#walls.find((one) => one.side === side2);
        return found ? found.wall.edge - shift : null;
      };
      return { left: at("left"), right: at("right") };
    }
    at(pressed2, shift) {
      const lines3 = this.#walls.map((one) => this.#draw(one, pressed2[one.side]));
      put(this.was, "d", lines3.join(""));
      put(this.was, "transform", `translate(${px(-shift)} 0)`);
    }
    #draw({ what, wall, group }, { dent, height }) {
      const { body: body2, hatch, face: face2, was, lines: lines3 } = what === "wall" ? { ...wallPaths(wall, this.layout, dent, height), hatch: null, lines: "" } : thingPaths(what, wall, this.layout, dent, height);
      put(need(group, ".carts-wall"), "d", body2);
      put(need(group, "[fill]"), "d", hatch ?? body2);
      put(need(group, ".carts-wall-face"), "d", face2);
      if (lines3) {
        const thing = need(group, THING);
        put(thing, "class", what === "spring" ? "carts-coil" : "carts-fine");
        put(thing, "d", lines3);
      }
      return was;
    }
  };

  // src/scene/stage.js
  var HANDLE2 = 9;
  var Stage = class {
    #run;
    #carts = [];
    #walls;
    #ground;
    #pushes;
    #effects;
    constructor(root, baked) {
      const layout = baked.view.layouts.find((one) => one.kind === root.dataset.kind);
      if (!layout) throw new Error(`no layout for ${root.dataset.kind}`);
      this.root = root;
      this.torn = false;
      this.layout = layout;
      this.view = baked.view;
      this.camera = baked.fence.camera;
      this.skins = baked.fence.skins;
      this.starts = baked.run.header.bodies.map(({ velocity: velocity2 }) => velocity2);
      this.#run = baked.run;
      this.#walls = new Walls(root, layout, baked);
      this.#ground = new Ground(root, layout, baked);
      this.#pushes = new Pushes(root, layout, baked.view);
      this.#effects = new Effects(root, layout, baked.view.force, baked.fence.forces === "shown");
    }
    show(run, windows) {
      this.#run = run;
      const { layout, view } = this;
      const boxes = run.header.bodies.map(
        (body2, i) => box(body2, view, layout, i, this.skins[body2.name])
      );
      this.torn = boxes.some((box2) => box2.cut);
      const tallest = Math.max(...boxes.map((box2) => box2.height));
      this.#carts = run.header.bodies.map((body2, i) => {
        const group = need(this.root, `.carts-cart[data-body="${body2.name}"]`);
        const box2 = boxes[i];
        drawBox(group, body2.name, box2);
        const skin = SKINS[this.skins[body2.name] ?? ""];
        const front = Number(this.starts[i]) < 0 ? -1 : 1;
        const lift = skin?.lift ?? 0;
        if (skin) put(need(group, '[data-part="skin"]'), "d", skin.lines(box2, front));
        return {
          half: body2.length * layout.scale / 2,
          edge: -box2.x,
          bumper: Math.max(0, body2.length * layout.scale / 2 + box2.x),
          height: box2.height + lift,
          lift,
          top: layout.track - lift + labelTop(box2),
          lane: lane(i, tallest, layout),
          group,
          mass: this.#mass(body2.name, box2, lift),
          velocity: need(this.root, `.carts-velocity[data-body="${body2.name}"]`)
        };
      });
      this.#walls.show(run.header.track);
      this.#ground.show(run.header.track);
      this.#pushes.show(run, windows);
      this.#effects.show(run);
    }
    at(t) {
      const { header, trajectory } = this.#run;
      const shift = this.camera * t;
      put(
        need(this.root, '[data-part="ground"]'),
        "transform",
        `translate(${px(-shift * this.layout.scale)} 0)`
      );
      const centres = header.bodies.map((body2) => {
        const x = valueAt2(
          trajectory.t,
          trajectory.x[body2.name] ?? [],
          trajectory.v[body2.name] ?? [],
          t
        );
        return this.layout.origin + (x - shift) * this.layout.scale;
      });
      const walls = this.#walls.faces(shift * this.layout.scale);
      const { left, right, dents } = squeezes(this.#carts, centres, walls);
      this.#walls.at(
        {
          left: { dent: dents.left, height: this.#carts[0]?.height ?? 0 },
          right: { dent: dents.right, height: this.#carts.at(-1)?.height ?? 0 }
        },
        shift * this.layout.scale
      );
      this.#carts.forEach((cart2, i) => {
        const centre = Number(centres[i]);
        const faces = [
          -cart2.half + Number(left[i]),
          cart2.half - Number(right[i])
        ];
        const foot = this.layout.track - cart2.lift;
        put(cart2.group, "transform", `translate(${px(centre)} ${px(foot)})`);
        put(cart2.mass, "x", px(centre));
        put(need(cart2.group, '[data-part="spring-left"]'), "d", spring(-cart2.edge, faces[0]));
        put(need(cart2.group, '[data-part="spring-right"]'), "d", spring(cart2.edge, faces[1]));
        put(need(cart2.group, '[data-part="face-left"]'), "transform", `translate(${px(faces[0])} 0)`);
        put(
          need(cart2.group, '[data-part="face-right"]'),
          "transform",
          `translate(${px(faces[1])} 0)`
        );
        this.#velocity(cart2, header.bodies[i]?.name ?? "", centre, t);
      });
      const face2 = (name, side2) => {
        const i = header.bodies.findIndex((body2) => body2.name === name);
        if (i < 0) {
          const wall = name === "left" ? 0 : header.track.length ?? 0;
          const dent = name === "left" ? -dents.left : dents.right;
          return this.layout.origin + (wall - shift) * this.layout.scale + dent;
        }
        const half = this.#carts[i]?.half ?? 0;
        const centre = Number(centres[i]);
        return side2 === "left" ? centre - half + Number(left[i]) : centre + half - Number(right[i]);
      };
      this.#pushes.at(t, face2);
      this.#effects.at(
        t,
        face2,
        (name) => Number(centres[header.bodies.findIndex((body2) => body2.name === name)])
      );
    }
    guess(guesses) {
      const { header } = this.#run;
      const group = need(this.root, '[data-part="guess"]');
      const full = this.view.force || 10;
      const parts2 = guesses.flatMap(({ pair, on, side: side2, size, slider: slider2 }) => {
        const i = header.bodies.findIndex((body3) => body3.name === on);
        const body2 = header.bodies[i];
        const half = (body2?.length ?? 0) / 2;
        const wall = on === "left" ? 0 : header.track.length ?? 0;
        const x = body2 ? body2.position + (side2 === "left" ? half : -half) : wall;
        const way = side2 === "left" ? -1 : 1;
        const length = way * arrowLength(size ?? 0, full, this.layout.force);
        const from = this.layout.origin + x * this.layout.scale;
        const y = this.layout.track - PUSH;
        const draw = isCut(size ?? 0, full) ? cutArrow : blockArrow;
        const style = `carts-${i < 0 ? "wall" : styleOf(i)}`;
        const arrow = svg("path", {
          class: `carts-guessed ${style}`,
          d: draw(from, y, length),
          "data-pair": pair,
          "data-on": on
        });
        const tip = from + length + way * HANDLE2;
        const handle = pullable(this.root, slider2, way * this.layout.force, this.layout.width);
        handle.setAttribute("class", `carts-pull ${style}`);
        handle.append(
          svg("circle", { cx: px(tip), cy: px(y), r: 16, class: "carts-pull-room" }),
          svg("circle", { cx: px(tip), cy: px(y), r: 8 }),
          svg("path", {
            d: `M${px(tip - 2.5)} ${px(y - 2.5)}l-2.5 2.5l2.5 2.5M${px(tip + 2.5)} ${px(y - 2.5)}l2.5 2.5l-2.5 2.5`
          })
        );
        return size === null ? [handle] : [arrow, handle];
      });
      group.replaceChildren(...parts2);
    }
    #mass(name, box2, lift) {
      const mass = need(this.root, `.carts-mass[data-body="${name}"]`);
      put(mass, "y", px(this.layout.track - lift + box2.labelY));
      say(mass, box2.label);
      return mass;
    }
    #velocity(cart2, name, x, t) {
      const { trajectory } = this.#run;
      const { layout, view } = this;
      const v = valueAt2(trajectory.t, trajectory.v[name] ?? [], trajectory.a[name] ?? [], t) - this.camera;
      const seen = Math.abs(v) < NOISE * view.velocity ? 0 : v;
      const exact = arrowLength(seen, view.velocity, layout.velocity, FASTEST);
      const length = keptInside(x, exact, layout.width);
      const [at, anchor] = velocityText(x, length, layout.width);
      put(need(cart2.velocity, '[data-part="arrow"]'), "d", lineArrow(x, cart2.lane, length));
      put(
        need(cart2.velocity, '[data-part="leader"]'),
        "d",
        `M${px(x)} ${px(cart2.lane)}V${px(cart2.top)}`
      );
      const shortened = length !== exact || isCut(seen, view.velocity, FASTEST);
      const cut = shortened ? tr(", arrow cut") : "";
      const [per, unit] = speedUnit(view.velocity);
      const speed = `${fixed(seen / per, view.decimals.v ?? 2)} ${unit}${cut}`;
      const text3 = need(cart2.velocity, '[data-part="text"]');
      const outside2 = x < 0 || x > layout.width;
      put(text3, "x", px(outside2 ? x < 0 ? 8 : layout.width - 8 : at));
      put(text3, "y", px(cart2.lane + 5));
      put(text3, "text-anchor", outside2 ? x < 0 ? "start" : "end" : anchor);
      say(text3, outside2 ? tr("{name} is outside: {speed}", { name, speed }) : speed);
    }
  };
  function drawBox(group, name, box2) {
    const rect = need(group, '[data-part="box"]');
    put(rect, "x", px(box2.x));
    put(rect, "y", px(-box2.height));
    put(rect, "width", px(box2.width));
    put(rect, "height", px(box2.height));
    const wheels2 = group.querySelector('[data-part="wheels"]');
    if (wheels2) put(wheels2, "d", wheels(box2));
    const cut = need(group, '[data-part="break"]');
    put(cut, "visibility", box2.cut ? "visible" : "hidden");
    const title = need(group, '[data-part="name"]');
    put(title, "y", px(box2.nameY ?? 0));
    put(title, "visibility", box2.nameY === null ? "hidden" : "visible");
    say(title, name);
  }

  // ../view/exits.js
  var HALVINGS = 40;
  function exits({ header, trajectory }, { low, high }, camera) {
    const { t: times2, x: places, v, a } = trajectory;
    const found = [];
    for (const { name, length } of header.bodies) {
      const half = length / 2;
      const place2 = (t) => valueAt2(times2, places[name] ?? [], v[name] ?? [], t) - camera * t;
      const isOut = (t) => Math.max(place2(t) - half - high, low - place2(t) - half) > 0;
      const row2 = Array.prototype.findIndex.call(times2, isOut);
      if (row2 < 1) continue;
      let before2 = Number(times2[row2 - 1]);
      let after2 = Number(times2[row2]);
      for (let k = 0; k < HALVINGS; k += 1) {
        const middle = (before2 + after2) / 2;
        if (isOut(middle)) after2 = middle;
        else before2 = middle;
      }
      const velocity2 = valueAt2(times2, v[name] ?? [], a[name] ?? [], after2) - camera;
      found.push({ t: after2, name, side: place2(after2) > high ? "right" : "left", velocity: velocity2 });
    }
    return found;
  }

  // ../view/model-words.js
  var BOTH_FORCES = tr(
    "Each contact has one force in the program: it acts on both bodies, equally hard, in opposite directions. So the program assumes Newton’s third law; it cannot prove it."
  );
  function modelSentences(header, numbers) {
    const acting = header.effects.filter(({ active }) => active);
    const sentences = acting.map((effect) => ended(capital(phrase(effect, header, numbers))));
    if (!acting.length) {
      sentences.push(
        tr("Where nothing touches, nothing pushes along the track: every cart keeps its velocity.")
      );
    }
    sentences.push(...contactSentences(header));
    if (header.contacts.some(({ stiffness }) => stiffness)) sentences.push(BOTH_FORCES);
    const leftOut = header.notSimulated.map((kind2) => viewOf(kind2).name);
    if (leftOut.length) {
      sentences.push(tr("Left out of this model: {effects}.", { effects: listed(leftOut) }));
    }
    return sentences;
  }
  function contactSentences(header) {
    const laws = lawsOf(header);
    const alike = /* @__PURE__ */ new Map();
    for (const contact of header.contacts) {
      if (laws[contact.pair] === APART) continue;
      const key2 = `${contact.restitution === null} ${contact.stiffness === null}`;
      alike.set(key2, [...alike.get(key2) ?? [], contact]);
    }
    return [...alike.values()].map((contacts) => {
      const [one] = contacts;
      const names = contacts.map(({ bodies }) => bodiesOf(bodies, header.track)).join("; ");
      const how = one?.stiffness ? tr("bumpers push like springs, the harder the more they are squeezed") : one?.restitution === null ? tr("whoever touches stays together") : tr("a hit takes no time");
      return ended(alike.size > 1 ? `${names}: ${how}` : capital(how));
    });
  }

  // src/scene/story.js
  var MOST_EVENTS2 = 60;
  var IN_FULL = 10;
  var Story = class {
    told = [];
    #seen = Infinity;
    // s, as far as the run was watched
    #listed = -1;
    // sentences that stand there
    #last = false;
    // whether the model stands there
    constructor(root, baked, seek) {
      const { fence, view } = baked;
      this.root = root;
      this.view = view;
      this.header = null;
      this.layout = view.layouts[0];
      this.telling = {
        decimals: view.decimals,
        scale: view.velocity,
        camera: fence.camera,
        forces: fence.forces === "shown"
      };
      this.list = need(root, ".carts-events");
      this.model = need(root, ".carts-model ul");
      this.list.addEventListener("click", (event) => {
        const button2 = event.target.closest("button");
        if (button2?.dataset.time) seek(Number(button2.dataset.time));
      });
    }
    show(run) {
      const { header } = run;
      const decimals = this.view.decimals.v ?? 2;
      const laws = lawsOf(header);
      const bare = bareOf(header);
      this.told = [
        ...isTold(run) ? marks(header, this.telling.forces) : [],
        ...header.events.map((event) => ({
          t: event.t,
          sentence: eventSentence(event, this.telling, laws, bare, header.track)
        })),
        ...exits(run, this.layout, this.telling.camera).map((exit) => ({
          t: exit.t,
          sentence: exitSentence(exit, decimals, this.view.velocity)
        }))
      ].sort((a, b) => a.t - b.t);
      this.header = header;
      this.#listed = -1;
      this.grow(this.#seen);
    }
    grow(seen) {
      this.#seen = seen;
      const seenOnes = this.told.filter(({ t }) => t <= seen);
      const whole = seen === Infinity;
      if (!this.header || seenOnes.length === this.#listed && whole === this.#last) return;
      [this.#listed, this.#last] = [seenOnes.length, whole];
      const items = seenOnes.slice(0, MOST_EVENTS2).map((one) => this.#item(one));
      const more = seenOnes.length - items.length;
      if (more > 0)
        items.push(
          html2(
            "li",
            "carts-more-events",
            counted("… and 1 more event.", "… and {n} more events.", more)
          )
        );
      this.list.replaceChildren(...items);
      const scrolled = items.length > IN_FULL;
      put(this.list, "class", scrolled ? "carts-events carts-events-scrolled" : "carts-events");
      if (scrolled) put(this.list, "tabindex", "0");
      else this.list.removeAttribute("tabindex");
      const open2 = whole && this.header.plan.length > 0;
      const hides = this.root.querySelector(".carts-find") !== null;
      const model3 = open2 && !hides ? modelSentences(this.header, this.telling.forces) : [];
      this.model.replaceChildren(...model3.map((text3) => html2("li", "", text3)));
      need(this.root, ".carts-model").hidden = !whole || hides;
    }
    #item({ t, sentence }) {
      const item = html2("li");
      const button2 = html2("button", "", `${fixed(t, this.view.decimals.t ?? 3)} s`);
      button2.setAttribute("type", "button");
      button2.className = "carts-jump";
      button2.dataset.time = String(t);
      item.append(button2, " ", html2("span", "", sentence));
      return item;
    }
    between(before2, now) {
      const after2 = before2 || -1;
      return this.told.filter(({ t }) => t > after2 && t <= now).map(({ sentence }) => sentence);
    }
  };

  // src/scene/time/timeline.js
  var MOST_EVENTS3 = 60;
  var BAND = { class: "carts-contact-band", y: 0, height: 18 };
  var Timeline = class {
    #until = 0;
    // s, as far as the axis goes
    #seen = Infinity;
    // s, as far as the run was watched
    #touches = [];
    #events = [];
    constructor(root, seek) {
      this.scrub = need(root, ".carts-scrub");
      this.bands = need(root, '.carts-ticks [data-part="contacts"]');
      this.marks = need(root, '.carts-ticks [data-part="events"]');
      this.numbers = need(root, '.carts-ticks [data-part="numbers"]');
      this.scrub.addEventListener("input", () => seek(this.scrub.valueAsNumber));
    }
    show(run, windows) {
      const { header } = run;
      const pushes3 = isTold(run) ? marks(header, false) : [];
      this.#touches = windows;
      this.#events = [
        ...header.events.slice(0, MOST_EVENTS3).filter((event) => event.kind !== "end"),
        ...pushes3.map(({ t }) => ({ t, kind: "push" }))
      ];
      if (this.#until !== header.until) this.#renumber(header.until);
      this.#mark();
    }
    grow(seen) {
      this.#seen = seen;
      if (this.#until) this.#mark();
    }
    #mark() {
      const at = (t) => `${px(100 * t / this.#until, 3)}%`;
      const touches2 = this.#touches.filter(({ start }) => start <= this.#seen);
      const events = this.#events.filter(({ t }) => t <= this.#seen);
      fit(this.bands, touches2.length, () => svg("rect", BAND));
      touches2.forEach(({ start, end: end2 }, k) => {
        const band4 = this.bands.children[k];
        put(band4, "x", at(start));
        put(band4, "width", at(Math.min(end2, this.#seen) - start));
      });
      fit(this.marks, events.length, () => svg("line", { y1: 1, y2: 17 }));
      events.forEach(({ t, kind: kind2 }, k) => {
        const mark = this.marks.children[k];
        put(mark, "class", `carts-event carts-event-${kind2}`);
        put(mark, "x1", at(t));
        put(mark, "x2", at(t));
      });
    }
    at(t, spoken) {
      this.scrub.valueAsNumber = t;
      put(this.scrub, "aria-valuetext", spoken);
    }
    #renumber(until) {
      this.#until = until;
      put(this.scrub, "max", String(until));
      const axis2 = span(0, until, 6);
      const times2 = ticks2(axis2);
      this.numbers.replaceChildren(
        ...times2.flatMap((t, i) => {
          const x = `${px(100 * t / until, 3)}%`;
          const text3 = svg("text", { class: "carts-number", x, y: 32 });
          text3.textContent = fixed(t, axisDecimals(axis2)) + (i === times2.length - 1 ? " s" : "");
          return [svg("line", { class: "carts-fine", x1: x, x2: x, y1: 14, y2: 20 }), text3];
        })
      );
    }
  };

  // src/scene/drawing.js
  var Drawing = class {
    run;
    windows = [];
    #seen = Infinity;
    constructor(root, baked, seek = () => {
    }) {
      this.root = root;
      this.baked = baked;
      this.run = baked.run;
      const stages = root.querySelectorAll(".carts-stage");
      this.stages = [...stages].map((stage2) => new Stage(stage2, baked));
      const graphs = root.querySelectorAll(".carts-graph");
      this.graphs = [...graphs].map((graph2) => new GraphView(graph2, baked, seek));
      this.views = new Views(root, baked);
      this.readouts = new Readouts(root, baked);
      this.timeline = new Timeline(root, seek);
      this.story = new Story(root, baked, seek);
      this.torn = root.querySelectorAll(".carts-torn");
      this.acting = root.querySelector(".carts-acting");
      this.warnings = need(root, ".carts-warnings");
      this.zoom = need(root, ".carts-window");
    }
    show(run, t) {
      this.run = run;
      this.windows = windowsOf(run);
      this.#words();
      this.stand();
      for (const graph2 of this.graphs) graph2.show(run, t);
      this.views.show(run, this.windows, t);
      this.readouts.show(run);
      this.timeline.show(run, this.windows);
      this.story.show(run);
      this.#offerWindows();
    }
    grow(seen) {
      if (seen === this.#seen) return;
      this.#seen = seen;
      for (const graph2 of this.graphs) graph2.grow(seen);
      this.timeline.grow(seen);
      this.story.grow(seen);
      this.#offerWindows();
    }
    at(t) {
      for (const stage2 of this.stages) stage2.at(t);
      for (const graph2 of this.graphs) graph2.at(t);
      this.views.at(t);
      this.readouts.at(t);
      this.timeline.at(t, tr("{time} seconds", { time: fixed(t, 2) }));
    }
    stand() {
      for (const stage2 of this.stages) stage2.show(this.run, this.windows);
      const torn2 = this.stages.some((stage2) => stage2.torn);
      for (const sign of this.torn) {
        if (torn2) sign.removeAttribute("hidden");
        put(sign, "data-now", torn2 ? "yes" : "no");
      }
    }
    #words() {
      const { header } = this.run;
      const numbers = isTold(this.run) && this.baked.fence.forces === "shown";
      if (this.acting) say(this.acting, actingSentences(header, numbers));
      this.warnings.hidden = header.warnings.length === 0;
      this.warnings.replaceChildren(
        ...header.warnings.map(({ message }) => html2("p", "", told(message)))
      );
    }
    #offerWindows() {
      const begun2 = this.windows.filter(({ start }) => start <= this.#seen);
      const texts = begun2.map(({ bodies, start }) => {
        const names = dashed(bodies, this.run.header.track);
        return tr("{names} at {time} s", { names, time: fixed(start, 2) });
      });
      const whole = need(this.zoom, "option");
      const there = [...this.zoom.options].slice(1);
      if (there.map(({ text: text3 }) => text3).join("\n") === texts.join("\n")) return;
      const chosen = this.zoom.selectedIndex;
      const options = texts.map((text3, i) => {
        const option = html2("option", "", text3);
        option.setAttribute("value", String(i));
        return option;
      });
      this.zoom.replaceChildren(whole, ...options);
      this.zoom.selectedIndex = chosen <= options.length ? chosen : 0;
    }
  };

  // src/draw-main.js
  var { document: document2 } = parseHTML("<!doctype html><html><body></body></html>");
  var KINDS2 = {
    scene,
    picture,
    cost,
    "cost-file": (values) => standalone(values).text,
    hard: (values) => inside2(values).text,
    map: ({ facts, draw, picture: picture2 }) => inside3(facts, draw, picture2).text,
    "map-picture": mapPicture,
    measured
  };
  function scene({ baked: raw, found }) {
    const baked = bakedOf(raw);
    const root = filled2("carts-scene", inside5(baked, found).text);
    const drawing = new Drawing(root, baked);
    if (baked.fence.watch === "first") drawing.grow(0);
    drawing.show(baked.run, 0);
    drawing.at(0);
    for (const { table: table4 } of drawing.graphs) table4.fill();
    for (const jump of root.querySelectorAll(".carts-jump")) jump.setAttribute("disabled", "");
    return root.innerHTML.replaceAll("&#160;", " ");
  }
  function picture({ baked: raw, at }) {
    const baked = bakedOf(raw);
    const narrow = baked.view.layouts.filter(({ kind: kind2 }) => kind2 === "narrow");
    const root = filled2("div", narrow.map((layout) => stage(baked, layout).text).join(""));
    const drawing = new Stage(need(root, ".carts-stage"), baked);
    drawing.show(baked.run, windowsOf(baked.run));
    drawing.at(at);
    return root.innerHTML;
  }
  function cost(values) {
    const root = filled2("carts-cost", inside(values).text);
    const stage2 = new CostStage(root);
    stage2.show(values.run.header, values.run.numbers);
    stage2.at(values.run.header.until);
    return root.innerHTML;
  }
  function mapPicture({ low, high, columns, values }) {
    const scale = scaleFor(low, high);
    const known2 = Float64Array.from(values, (value) => value ?? Number.NaN);
    const { places, width, height } = pixels(known2, columns, scale);
    const letters = Array.from(places, (place2) => String.fromCharCode(48 + place2)).join("");
    return JSON.stringify({ width, height, letters, palette: palette(scale) });
  }
  function measured(facts) {
    const root = filled2("carts-measured", inside4(facts).text);
    const [place2, left] = [".carts-measured-figure", ".carts-measured-left"].map(
      (one) => need(root, one)
    );
    if (place2 && left && facts.read) {
      new Figure(place2, left).show(facts.read.tracks, heads(facts.read), null);
    }
    return root.innerHTML;
  }
  function filled2(name, markup) {
    const root = document2.createElement(name);
    root.innerHTML = markup;
    document2.body.replaceChildren(root);
    return root;
  }
  globalThis.cartsDraw = (kind2, values) => {
    const draw = KINDS2[kind2];
    globalThis.document = document2;
    if (!draw) throw new Error(`nothing draws “${kind2}”`);
    return draw(values);
  };
})();
